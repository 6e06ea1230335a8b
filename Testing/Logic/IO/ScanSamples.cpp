#include "Testing/Logic/IO/ScanSamples.h"

#include <jpeglib.h>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <algorithm>
#include <sstream>

#include "Logic/IO/Lzf.h"

namespace falciform::test {

namespace {

struct PcdPoint {
  float x, y, z;
  std::uint32_t rgb;
};

std::string fieldByField(const std::vector<PcdPoint>& points) {
  std::string bytes;
  for (std::size_t at = 0; at < sizeof(PcdPoint); at += 4)
    for (const PcdPoint& point : points) bytes.append(reinterpret_cast<const char*>(&point) + at, 4);
  return bytes;
}

}  // namespace

Points tiltedSheet(int rows, int columns) {
  Points points(static_cast<Index>(rows) * columns, 3);
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < columns; ++c) points.row(static_cast<Index>(r) * columns + c) << c, r, 300 + 0.1 * c;
  return points;
}

std::string pcdOf(const Points& points, int rows, int columns, const std::vector<int>& missing,
                  const std::string& coding) {
  std::vector<PcdPoint> data;
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < columns; ++c) {
      const Index i = static_cast<Index>(r) * columns + c;
      const bool gone = std::find(missing.begin(), missing.end(), i) != missing.end();
      const float nan = std::numeric_limits<float>::quiet_NaN();
      data.push_back({gone ? nan : static_cast<float>(points(i, 0)), static_cast<float>(points(i, 1)),
                      static_cast<float>(points(i, 2)),
                      static_cast<std::uint32_t>(r) << 16 | static_cast<std::uint32_t>(c) << 8 | 7U});
    }
  std::ostringstream text;
  text << "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z rgb\nSIZE 4 4 4 4\n"
       << "TYPE F F F U\nCOUNT 1 1 1 1\nWIDTH " << columns << "\nHEIGHT " << rows
       << "\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " << rows * columns << "\nDATA " << coding << '\n';
  if (coding == "ascii")
    for (const PcdPoint& p : data) text << p.x << ' ' << p.y << ' ' << p.z << ' ' << p.rgb << '\n';
  std::string bytes = text.str();
  if (coding == "binary")
    bytes.append(reinterpret_cast<const char*>(data.data()), data.size() * sizeof(PcdPoint));
  if (coding == "binary_compressed") {
    const std::string whole = fieldByField(data), packed = packLzfLiterally(whole);
    for (const std::size_t size : {packed.size(), whole.size()}) {
      const auto number = static_cast<std::uint32_t>(size);
      bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
    }
    bytes += packed;
  }
  return bytes;
}

std::string rangeGridOf(const Points& points, int rows, int columns, const std::vector<int>& missing) {
  std::ostringstream text, body;
  int count = 0;
  std::vector<int> now(static_cast<std::size_t>(points.rows()), -1);
  for (Index i = 0; i < points.rows(); ++i) {
    if (std::find(missing.begin(), missing.end(), static_cast<int>(i)) != missing.end()) continue;
    body << points.row(i) << '\n';
    now[static_cast<std::size_t>(i)] = count++;
  }
  for (int r = rows - 1; r >= 0; --r)
    for (int c = 0; c < columns; ++c) {
      const int point = now[static_cast<std::size_t>(r * columns + c)];
      body << (point < 0 ? std::string("0") : "1 " + std::to_string(point)) << '\n';
    }
  text << "ply\nformat ascii 1.0\nobj_info num_cols " << columns << "\nobj_info num_rows " << rows
       << "\nelement vertex " << count << "\nproperty float x\nproperty float y\nproperty float z\n"
       << "element range_grid " << rows * columns << "\nproperty list uchar int vertex_indices\nend_header\n"
       << body.str();
  return text.str();
}

ColourImage gradientImage(int width, int height) {
  ColourImage image{width, height, {}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      image.rgb.insert(image.rgb.end(), {static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y), 40});
  return image;
}

DepthImage slantedDepths(int width, int height) {
  DepthImage image{width, height, {}};
  for (int v = 0; v < height; ++v)
    for (int u = 0; u < width; ++u)
      image.depth.push_back(u == 0 ? std::uint16_t{0} : static_cast<std::uint16_t>(500 + 2 * (u - v)));
  return image;
}

double facingShare(const Surface& surface, const Vector3d& eye) {
  Index facing = 0;
  for (Index t = 0; t < surface.triangles.rows(); ++t) {
    const Vector3d a = surface.points.row(surface.triangles(t, 0)),
                   b = surface.points.row(surface.triangles(t, 1)),
                   c = surface.points.row(surface.triangles(t, 2));
    facing += (b - a).cross(c - a).dot(eye - a) > 0;
  }
  return surface.triangles.rows() == 0
             ? 0
             : static_cast<double>(facing) / static_cast<double>(surface.triangles.rows());
}

std::string smallJpeg() {
  constexpr int kSide = 16;
  jpeg_compress_struct jpeg{};
  jpeg_error_mgr errors{};
  jpeg.err = jpeg_std_error(&errors);
  jpeg_create_compress(&jpeg);
  unsigned char* bytes = nullptr;
  unsigned long count = 0;
  jpeg_mem_dest(&jpeg, &bytes, &count);
  jpeg.image_width = kSide;
  jpeg.image_height = kSide;
  jpeg.input_components = 3;
  jpeg.in_color_space = JCS_RGB;
  jpeg_set_defaults(&jpeg);
  jpeg_start_compress(&jpeg, TRUE);
  std::vector<unsigned char> row;
  for (int x = 0; x < kSide; ++x) row.insert(row.end(), {200, 60, 40});
  for (int y = 0; y < kSide; ++y) {
    JSAMPROW at = row.data();
    jpeg_write_scanlines(&jpeg, &at, 1);
  }
  jpeg_finish_compress(&jpeg);
  std::string result(reinterpret_cast<const char*>(bytes), count);
  jpeg_destroy_compress(&jpeg);
  std::free(bytes);
  return result;
}

}  // namespace falciform::test
