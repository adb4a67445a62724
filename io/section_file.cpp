#include "section_file.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <utility>
#include <vector>

#include "../geom/failing.h"
#include "file_extension.h"
#include "open_file.h"
#include "section_conventions.h"
#include "section_grammar.h"

namespace crossloft {
namespace {

/// Bytes of a file from anywhere.
class RandomFile {
 public:
  static Result<RandomFile> open(const std::string& path) {
    auto file = open_to_read(path);
    if (!file) return file.error();
    RandomFile out;
    out.path_ = path;
    out.file_ = std::move(file).value();
    errno = 0;
    if (std::fseek(out.file_.get(), 0, SEEK_END) != 0)
      return out.error(errno == ESPIPE ? "it is a pipe, and a stream reads its file more than once" : "");
    const long size = std::ftell(out.file_.get());
    if (size < 0) return out.error();
    out.size_ = static_cast<std::uint64_t>(size);
    return out;
  }

  std::uint64_t size() const { return size_; }

  /// As many bytes as there are of those wanted.
  Result<Done> read(std::uint64_t begin, std::uint64_t count, std::string& bytes) {
    bytes.resize(begin < size_ ? std::min(count, size_ - begin) : 0);
    errno = 0;
    if (std::fseek(file_.get(), static_cast<long>(begin), SEEK_SET) != 0 ||
        std::fread(bytes.data(), 1, bytes.size(), file_.get()) != bytes.size())
      return error();
    return Done{};
  }

 private:
  Error error(const std::string& why = {}) const {
    return not_readable(path_, why.empty() ? reason(errno != 0 ? errno : EIO) : why);
  }

  std::string path_;
  OpenFile file_;
  std::uint64_t size_ = 0;
};

/// Where a text begins in the file.
struct Place {
  std::uint64_t offset = 0;
  std::uint32_t line = 1;
};

/// Reads a file from its begin to its end, holding as much of it as one record takes.
class RecordReader {
 public:
  RecordReader(RandomFile& file, std::string name) : file_(file), name_(std::move(name)) {}

  Place place() const { return place_; }
  bool at_end() const { return place_.offset >= file_.size(); }

  /// parse(TokenReader&) reads the next record. It is called again with more text while it may have lacked
  /// some: if it came to the end of its text.
  template <class Parse>
  Result<Done> next(Parse&& parse) {
    for (;; size_ *= 2) {
      if (auto good = file_.read(place_.offset, size_, text_); !good) return good;
      TokenReader in(text_, name_);
      in.begin_at(place_.line, file_.size());
      parse(in);
      const bool is_all = place_.offset + text_.size() >= file_.size();
      if (in.offset() == text_.size() && !is_all) continue;
      if (!in.ok()) return in.error();
      size_ = std::max<std::uint64_t>(kLeast, in.offset() + in.offset() / 2);
      place_ = {place_.offset + in.offset(), in.line()};
      return Done{};
    }
  }

 private:
  static constexpr std::uint64_t kLeast = 1 << 12;

  RandomFile& file_;
  std::string name_, text_;
  Place place_;
  std::uint64_t size_ = kLeast;  ///< of the text to be tried
};

}  // namespace

struct SectionFile::Index {
  std::string path;
  const SectionGrammar* grammar = nullptr;
  RandomFile file;
  SectionConventions conventions;
  std::vector<Place> places;  ///< of the planes, and the end of the last

  Result<Done> survey(const Context& context) {
    RecordReader records(file, path);
    std::uint32_t planes = 0;
    if (auto good = records.next([&](TokenReader& in) { planes = grammar->header(in); }); !good) return good;
    for (std::uint32_t p = 0; p < planes; ++p) {
      if (context.cancelled()) return Error{ErrorCode::cancelled, "reading was cancelled", path, 0, p, kNone};
      context.report("reading",
                     static_cast<double>(records.place().offset) / static_cast<double>(file.size()));
      places.push_back(records.place());
      ParsedPlane plane;
      const auto good = records.next([&](TokenReader& in) {
        in.enter(p);
        plane = grammar->plane(in, p);
      });
      if (!good) return good;
      conventions.observe(plane);
    }
    places.push_back(records.place());
    if (auto good = records.next([](TokenReader& in) { in.expect_end(); }); !good) return good;
    conventions.tell(context);
    return Done{};
  }
};

Result<SectionFile> SectionFile::open(const std::string& path, const Context& context) {
  return or_out_of_memory([&]() -> Result<SectionFile> {
    auto index = std::make_unique<Index>();
    index->path = path;
    index->grammar = grammar_of(path);
    if (index->grammar == nullptr) return unknown_extension(path, ".contour and .csl");
    auto file = RandomFile::open(path);
    if (!file) return file.error();
    index->file = std::move(file).value();
    if (auto good = index->survey(context); !good) return good.error();
    return SectionFile(std::move(index));
  });
}

SectionFile::SectionFile(std::unique_ptr<Index> index) : index_(std::move(index)) {}
SectionFile::SectionFile(SectionFile&&) noexcept = default;
SectionFile::~SectionFile() = default;

std::string SectionFile::name() const { return index_->path; }

std::uint32_t SectionFile::plane_count() const {
  return static_cast<std::uint32_t>(index_->places.size() - 1);
}

Result<PlaneSection> SectionFile::read(std::uint32_t position) {
  return or_out_of_memory([&]() -> Result<PlaneSection> {
    const Place from = index_->places[position], to = index_->places[position + 1];
    std::string text;
    if (auto good = index_->file.read(from.offset, to.offset - from.offset, text); !good) return good.error();
    TokenReader in(text, index_->path);
    in.begin_at(from.line, index_->file.size());
    in.enter(position);
    ParsedPlane plane = index_->grammar->plane(in, position);
    if (!in.ok()) return in.error();
    index_->conventions.apply(plane.section);
    return std::move(plane.section);
  });
}

}  // namespace crossloft
