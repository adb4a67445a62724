#include "read_sites.h"
#include "../geom/failing.h"

#include <utility>

#include "atomic_file.h"
#include "token_reader.h"

namespace crossloft {
namespace {

MoebiusSite read_site(TokenReader& in) {
  MoebiusSite site;
  site.p.x = in.real("the x of a site");
  if (in.at_line_end()) in.fail(ErrorCode::syntax, "one number, where a site is x y [lambda [mu]]");
  site.p.y = in.real("the y of a site");
  if (!in.at_line_end()) site.lambda = in.real("the lambda of a site");
  if (!in.at_line_end()) site.mu = in.real("the mu of a site");
  if (!in.at_line_end())
    in.fail(ErrorCode::syntax, "more than four numbers, where a site is x y [lambda [mu]]");
  return site;
}

}  // namespace

Result<std::vector<MoebiusSite>> parse_sites(std::string_view text, std::string name) {
  return or_out_of_memory([&]() -> Result<std::vector<MoebiusSite>> {
    std::vector<MoebiusSite> sites;
    TokenReader in(text, std::move(name), '#');
    while (in.ok() && !in.at_end()) sites.push_back(read_site(in));
    if (sites.empty()) in.fail(ErrorCode::truncated, "no site in the file");
    if (!in.ok()) return in.error();
    return sites;
  });
}

Result<std::vector<MoebiusSite>> read_sites(const std::string& path) {
  return or_out_of_memory([&]() -> Result<std::vector<MoebiusSite>> {
    const Result<std::string> text = read_file(path);
    if (!text.ok()) return text.error();
    return parse_sites(*text, path);
  });
}

}  // namespace crossloft
