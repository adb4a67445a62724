#include "read_sections.h"
#include "../geom/failing.h"

#include "atomic_file.h"
#include "file_extension.h"
#include "section_conventions.h"
#include "section_grammar.h"

namespace crossloft {
namespace {

Result<Sections> parse(const SectionGrammar& grammar, std::string_view text, std::string name,
                       const Context& context) {
  return or_out_of_memory([&]() -> Result<Sections> {
    Sections sections;
    sections.source = name;
    TokenReader in(text, std::move(name));
    SectionConventions conventions;
    const std::uint32_t planes = grammar.header(in);
    for (std::uint32_t p = 0; p < planes && in.ok(); ++p) {
      if (context.cancelled()) in.fail(ErrorCode::cancelled, "reading was cancelled");
      in.enter(p);
      ParsedPlane plane = grammar.plane(in, p);
      if (in.ok()) conventions.observe(plane);
      sections.planes.push_back(std::move(plane.section));
    }
    in.enter(kNone);
    in.expect_end();
    if (!in.ok()) return in.error();
    conventions.tell(context);
    for (PlaneSection& plane : sections.planes) conventions.apply(plane);
    return sections;
  });
}

}  // namespace

const SectionGrammar* grammar_of(const std::string& path) {
  const std::string extension = file_extension(path);
  return extension == "csl" ? &csl_grammar() : extension == "contour" ? &contour_grammar() : nullptr;
}

Result<Sections> parse_contour(std::string_view text, std::string name, const Context& context) {
  return parse(contour_grammar(), text, std::move(name), context);
}

Result<Sections> parse_csl(std::string_view text, std::string name, const Context& context) {
  return parse(csl_grammar(), text, std::move(name), context);
}

Result<Sections> read_sections(const std::string& path, const Context& context) {
  return or_out_of_memory([&]() -> Result<Sections> {
    const SectionGrammar* grammar = grammar_of(path);
    if (grammar == nullptr) return unknown_extension(path, ".contour and .csl");
    const Result<std::string> text = read_file(path);
    if (!text.ok()) return text.error();
    return parse(*grammar, *text, path, context);
  });
}

}  // namespace crossloft
