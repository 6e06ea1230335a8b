#include <png.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>

#include "Logic/Core/Errors.h"
#include "Logic/IO/ImageCodecs.h"
#include "Logic/IO/NumberText.h"

// libpng reports errors by longjmp, which runs no destructors: the functions that may be left so hold plain
// values only, and what they fill belongs to their callers.

namespace falciform {

namespace {

struct Source {
  const char* at;
  std::size_t left;
};

/// What goes wrong stands in `text` when the jump comes.
struct Problem {
  char text[160] = "it is damaged";
};

[[noreturn]] void onError(png_structp png, png_const_charp message) {
  auto* problem = static_cast<Problem*>(png_get_error_ptr(png));
  std::strncpy(problem->text, message, sizeof problem->text - 1);
  png_longjmp(png, 1);
}

void onWarning(png_structp, png_const_charp) {}

void readBytes(png_structp png, png_bytep into, std::size_t count) {
  auto* source = static_cast<Source*>(png_get_io_ptr(png));
  if (count > source->left) png_error(png, "it ends too early (truncated)");
  std::memcpy(into, source->at, count);
  source->at += count;
  source->left -= count;
}

/// A reader that is closed whatever happens.
struct PngReader {
  png_structp png = nullptr;
  png_infop info = nullptr;
  Problem problem;

  PngReader() {
    png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &problem, onError, onWarning);
    info = png ? png_create_info_struct(png) : nullptr;
    if (!info) throw std::runtime_error("libpng does not start");
  }
  ~PngReader() { png_destroy_read_struct(&png, &info, nullptr); }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;
};

bool readHead(PngReader& reader, Source& source) {
  if (setjmp(png_jmpbuf(reader.png))) return false;
  png_set_user_limits(reader.png, 0x7fffffff, 0x7fffffff);
  png_set_read_fn(reader.png, &source, readBytes);
  png_read_info(reader.png, reader.info);
  return true;
}

bool askForColours(PngReader& reader) {
  if (setjmp(png_jmpbuf(reader.png))) return false;
  png_set_expand(reader.png);
  png_set_scale_16(reader.png);
  png_set_strip_alpha(reader.png);
  png_set_gray_to_rgb(reader.png);
  (void)png_set_interlace_handling(reader.png);
  png_read_update_info(reader.png, reader.info);
  return true;
}

bool askForDepths(PngReader& reader) {
  if (setjmp(png_jmpbuf(reader.png))) return false;
  png_set_swap(reader.png);  // files are big endian, and this machine is not
  (void)png_set_interlace_handling(reader.png);
  png_read_update_info(reader.png, reader.info);
  return true;
}

bool readRows(PngReader& reader, png_bytepp rows) {
  if (setjmp(png_jmpbuf(reader.png))) return false;
  png_read_image(reader.png, rows);
  png_read_end(reader.png, nullptr);
  return true;
}

[[noreturn]] void refuse(const PngReader& reader, const std::string& name) {
  std::string problem(reader.problem.text);
  std::replace(problem.begin(), problem.end(), '\n', ' ');
  throw InputError(name + " is no sound PNG (" + problem + "); save it again");
}

/// Pixels of `channels` values of `T` each, as the reader was asked for them.
template <class T>
std::vector<T> pixelsOf(PngReader& reader, std::size_t channels, const std::string& name) {
  const std::size_t width = png_get_image_width(reader.png, reader.info),
                    height = png_get_image_height(reader.png, reader.info);
  if (png_get_rowbytes(reader.png, reader.info) != width * channels * sizeof(T)) refuse(reader, name);
  std::vector<T> pixels(width * height * channels);
  std::vector<png_bytep> rows(height);
  for (std::size_t y = 0; y < height; ++y)
    rows[y] = reinterpret_cast<png_bytep>(pixels.data() + y * width * channels);
  if (!readRows(reader, rows.data())) refuse(reader, name);
  return pixels;
}

void open(PngReader& reader, Source& source, std::size_t bytes, const std::string& name) {
  if (!readHead(reader, source)) refuse(reader, name);
  checkPixels(png_get_image_width(reader.png, reader.info), png_get_image_height(reader.png, reader.info),
              bytes, name);
}

struct PngWriter {
  png_structp png = nullptr;
  png_infop info = nullptr;
  std::string bytes;

  PngWriter() {
    png = png_create_write_struct(
        PNG_LIBPNG_VER_STRING, nullptr,
        [](png_structp, png_const_charp message) {
          throw std::runtime_error(std::string("libpng: ") + message);
        },
        onWarning);
    info = png ? png_create_info_struct(png) : nullptr;
    if (!info) throw std::runtime_error("libpng does not start");
    png_set_write_fn(
        png, &bytes,
        [](png_structp own, png_bytep from, std::size_t count) {
          static_cast<std::string*>(png_get_io_ptr(own))->append(reinterpret_cast<const char*>(from), count);
        },
        nullptr);
  }
  ~PngWriter() { png_destroy_write_struct(&png, &info); }
  PngWriter(const PngWriter&) = delete;
  PngWriter& operator=(const PngWriter&) = delete;

  void head(int width, int height, int bits, int kind) const {
    png_set_IHDR(png, info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height), bits, kind,
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  }
  void row(const void* from) const { png_write_row(png, static_cast<png_const_bytep>(from)); }
};

}  // namespace

bool isPng(std::string_view bytes) { return bytes.starts_with(std::string_view("\x89PNG\r\n\x1a\n", 8)); }

ColourImage decodePng(const std::string& bytes, const std::string& name) {
  PngReader reader;
  Source source{bytes.data(), bytes.size()};
  open(reader, source, bytes.size(), name);
  if (!askForColours(reader)) refuse(reader, name);
  return {static_cast<int>(png_get_image_width(reader.png, reader.info)),
          static_cast<int>(png_get_image_height(reader.png, reader.info)),
          pixelsOf<std::uint8_t>(reader, 3, name)};
}

DepthImage decodeDepthPng(const std::string& bytes, const std::string& name) {
  PngReader reader;
  Source source{bytes.data(), bytes.size()};
  open(reader, source, bytes.size(), name);
  if (png_get_bit_depth(reader.png, reader.info) != 16 ||
      png_get_color_type(reader.png, reader.info) != PNG_COLOR_TYPE_GRAY)
    throw InputError(name + " is a PNG of " +
                     std::to_string(int{png_get_bit_depth(reader.png, reader.info)}) +
                     " bits a channel or of several channels; depths are one channel of 16 bits");
  if (!askForDepths(reader)) refuse(reader, name);
  return {static_cast<int>(png_get_image_width(reader.png, reader.info)),
          static_cast<int>(png_get_image_height(reader.png, reader.info)),
          pixelsOf<std::uint16_t>(reader, 1, name)};
}

std::string encodePng(const ColourImage& image,
                      const std::vector<std::pair<std::string, std::string>>& texts) {
  PngWriter writer;
  writer.head(image.width, image.height, 8, PNG_COLOR_TYPE_RGB);
  for (const auto& [keyword, text] : texts) {
    png_text chunk{};
    chunk.compression = PNG_TEXT_COMPRESSION_NONE;
    chunk.key = const_cast<char*>(keyword.c_str());
    chunk.text = const_cast<char*>(text.c_str());
    chunk.text_length = text.size();
    png_set_text(writer.png, writer.info, &chunk, 1);
  }
  png_write_info(writer.png, writer.info);
  const std::size_t width = 3 * static_cast<std::size_t>(image.width);
  for (int y = 0; y < image.height; ++y) writer.row(image.rgb.data() + width * static_cast<std::size_t>(y));
  png_write_end(writer.png, nullptr);
  return std::move(writer.bytes);
}

std::string encodePng(const DepthImage& image) {
  PngWriter writer;
  writer.head(image.width, image.height, 16, PNG_COLOR_TYPE_GRAY);
  png_write_info(writer.png, writer.info);
  png_set_swap(writer.png);
  const auto width = static_cast<std::size_t>(image.width);
  for (int y = 0; y < image.height; ++y) writer.row(image.depth.data() + width * static_cast<std::size_t>(y));
  png_write_end(writer.png, nullptr);
  return std::move(writer.bytes);
}

void checkPixels(double width, double height, std::size_t bytes, const std::string& name) {
  constexpr double kPixelsAByte = 1032;
  if (width < 1 || height < 1 || width * height > kPixelsAByte * static_cast<double>(bytes))
    throw InputError(name + " announces " + numberText(width) + " x " + numberText(height) +
                     " pixels, which its " + std::to_string(bytes) + " bytes cannot hold; save it again");
}

}  // namespace falciform
