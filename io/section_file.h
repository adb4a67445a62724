#pragma once
/// A file of cross-sections that is read plane by plane, any of them again: memory holds the text of one
/// plane.

#include <cstdint>
#include <memory>
#include <string>

#include "../geom/context.h"
#include "../geom/result.h"
#include "../reconstruct/stack.h"

namespace crossloft {

/// What read_sections() reads, one plane at a time. Opening reads the whole file once, so that its errors are
/// those of read_sections() and the sign of D and the materials are settled for all planes. A file that
/// changes meanwhile is an error, or another file. Not for pipes: the file is read again from the middle.
class SectionFile : public SectionSource {
 public:
  /// Errors: as read_sections().
  static Result<SectionFile> open(const std::string& path, const Context& context = {});
  ~SectionFile() override;
  SectionFile(SectionFile&&) noexcept;

  std::string name() const override;
  std::uint32_t plane_count() const override;
  Result<PlaneSection> read(std::uint32_t position) override;

 private:
  struct Index;
  explicit SectionFile(std::unique_ptr<Index> index);

  std::unique_ptr<Index> index_;
};

}  // namespace crossloft
