#include "png_file.h"

#include <png.h>

#include "../../io/atomic_file.h"

namespace crossloft::cli {

Result<Done> write_png(const std::string& path, const Image& image) {
  png_image header = {};
  header.version = PNG_IMAGE_VERSION;
  header.width = image.width;
  header.height = image.height;
  header.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(header);
  std::string bytes(size, '\0');
  if (png_image_write_to_memory(&header, bytes.data(), &size, 0, image.rgb.data(), 0, nullptr) == 0) {
    return Error{ErrorCode::internal, std::string("PNG: ") + header.message, path};
  }
  bytes.resize(size);
  return write_file(path, bytes);
}

}  // namespace crossloft::cli
