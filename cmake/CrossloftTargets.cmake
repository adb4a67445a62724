# Flags that every target of the project shares, and why.
function(crossloft_compile_options target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor)
  if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    target_compile_options(${target} PRIVATE -Wno-restrict)  # false alarms on "x" + std::string (GCC bug 105651)
  endif()
  # The error bounds of the predicates hold for separately rounded operations; a fused multiply-add would
  # also make results depend on the platform. Public: the templates of the headers need it too.
  target_compile_options(${target} PUBLIC -ffp-contract=off)
  if(CROSSLOFT_WARNINGS_AS_ERRORS)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
  if(CROSSLOFT_VERIFY)
    target_compile_definitions(${target} PUBLIC CROSSLOFT_VERIFY=1)
  endif()
endfunction()
