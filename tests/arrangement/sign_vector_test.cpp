#include "../../arrangement/sign_vector.h"

#include <doctest/doctest.h>

#include <vector>

using namespace crossloft;

namespace {

struct Rows {
  std::vector<SignWord> pos, zero;
  SignView view() const { return {pos, zero}; }
};

Rows rows(const std::vector<int>& signs) {
  Rows r{std::vector<SignWord>(sign_words(signs.size())), std::vector<SignWord>(sign_words(signs.size()))};
  for (std::uint32_t p = 0; p < signs.size(); ++p) {
    if (signs[p] > 0) set_bit(r.pos, PlaneId(p));
    if (signs[p] == 0) set_bit(r.zero, PlaneId(p));
  }
  return r;
}

}  // namespace

TEST_CASE("rows have a word for every 64 planes, and at least one") {
  CHECK(sign_words(0) == 1);
  CHECK(sign_words(64) == 1);
  CHECK(sign_words(65) == 2);
}

TEST_CASE("signs are read back across words") {
  std::vector<int> signs;
  for (int p = 0; p < 150; ++p) signs.push_back(p * p % 7 % 3 - 1);
  const Rows r = rows(signs);
  for (std::uint32_t p = 0; p < 150; ++p) CHECK(sign_at(r.view(), PlaneId(p)) == signs[p]);
}

TEST_CASE("the closure has the same signs or zero") {
  for (const int low : {-1, 0, 1})
    for (const int high : {-1, 0, 1}) {
      std::vector<int> a(70, 1), b(70, 1);
      a[65] = low, b[65] = high;
      const Rows ra = rows(a), rb = rows(b);
      CHECK(in_closure(ra.view(), rb.view()) == (low == 0 || low == high));
      CHECK(equal_signs(ra.view(), rb.view()) == (low == high));
    }
}
