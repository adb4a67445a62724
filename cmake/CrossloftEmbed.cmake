# crossloft_embed(SOURCE TARGET): TARGET becomes the text of SOURCE as comma-separated string literals, for an
# array's initializer. Written anew when SOURCE changes.
function(crossloft_embed source target)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${source})
  file(READ ${source} text)
  string(LENGTH "${text}" length)
  set(literals "")
  set(piece 8000)
  foreach(start RANGE 0 ${length} ${piece})
    string(SUBSTRING "${text}" ${start} ${piece} part)
    string(APPEND literals "R\"_(${part})_\",\n")
  endforeach()
  file(CONFIGURE OUTPUT ${target} CONTENT "${literals}" @ONLY)
endfunction()
