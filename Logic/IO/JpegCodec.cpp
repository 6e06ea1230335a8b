#include <csetjmp>
#include <cstddef>
#include <cstdio>
// libjpeg's header needs the ones above and does not name them.
#include <jpeglib.h>

#include <algorithm>

#include "Logic/Core/Errors.h"
#include "Logic/IO/ImageCodecs.h"

// As with libpng: errors come by longjmp, so what may be left so holds plain values only.

namespace falciform {

namespace {

struct JpegErrors {
  jpeg_error_mgr base{};  // first, so that a pointer to it is one to the whole
  jmp_buf jump;
  char text[JMSG_LENGTH_MAX] = "it is damaged";
};

void onError(j_common_ptr jpeg) {
  auto* errors = reinterpret_cast<JpegErrors*>(jpeg->err);
  (*errors->base.format_message)(jpeg, errors->text);
  std::longjmp(errors->jump, 1);
}

/// Warnings are damage: libjpeg would go on with grey.
void onMessage(j_common_ptr jpeg, int level) {
  if (level < 0) onError(jpeg);
}

struct JpegReader {
  jpeg_decompress_struct jpeg{};
  JpegErrors errors;

  JpegReader() {
    jpeg.err = jpeg_std_error(&errors.base);
    errors.base.error_exit = onError;
    errors.base.emit_message = onMessage;
  }
  ~JpegReader() { jpeg_destroy_decompress(&jpeg); }
  JpegReader(const JpegReader&) = delete;
  JpegReader& operator=(const JpegReader&) = delete;
};

bool readHead(JpegReader& reader, const unsigned char* bytes, std::size_t count) {
  if (setjmp(reader.errors.jump)) return false;
  jpeg_create_decompress(&reader.jpeg);
  jpeg_mem_src(&reader.jpeg, bytes, count);
  jpeg_read_header(&reader.jpeg, TRUE);
  reader.jpeg.out_color_space = JCS_RGB;
  return true;
}

bool readRows(JpegReader& reader, std::uint8_t* pixels) {
  if (setjmp(reader.errors.jump)) return false;
  jpeg_start_decompress(&reader.jpeg);
  const std::size_t width = std::size_t{3} * reader.jpeg.output_width;
  while (reader.jpeg.output_scanline < reader.jpeg.output_height) {
    JSAMPROW row = pixels + width * reader.jpeg.output_scanline;
    jpeg_read_scanlines(&reader.jpeg, &row, 1);
  }
  jpeg_finish_decompress(&reader.jpeg);
  return true;
}

}  // namespace

ColourImage decodeJpeg(const std::string& bytes, const std::string& name) {
  JpegReader reader;
  const auto refuse = [&] {
    std::string problem(reader.errors.text);
    std::replace(problem.begin(), problem.end(), '\n', ' ');
    throw InputError(name + " is no sound JPEG (" + problem + "); save it again, or as .png");
  };
  if (!readHead(reader, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size())) refuse();
  checkPixels(reader.jpeg.image_width, reader.jpeg.image_height, bytes.size(), name);
  ColourImage image{
      static_cast<int>(reader.jpeg.image_width), static_cast<int>(reader.jpeg.image_height), {}};
  image.rgb.resize(std::size_t{3} * reader.jpeg.image_width * reader.jpeg.image_height);
  if (!readRows(reader, image.rgb.data())) refuse();
  return image;
}

}  // namespace falciform
