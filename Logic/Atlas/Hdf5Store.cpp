#include "Logic/Atlas/Hdf5Store.h"

#include <hdf5.h>

#include <algorithm>
#include <fstream>
#include <stdexcept>

#include "Logic/Atlas/SealedFile.h"
#include "Logic/Core/Errors.h"

namespace falciform {
namespace {

constexpr std::size_t kGrowth = 1 << 22;  // bytes by which a file in memory grows

/// An HDF5 identifier that is closed at the end of the scope.
class Handle {
 public:
  Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  operator hid_t() const { return id_; }
  [[nodiscard]] bool valid() const { return id_ >= 0; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

/// Errors are ours to tell; HDF5 would print them.
void keepHdf5Quiet() { H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); }

Handle spaceOf(const Lengths& lengths) {
  if (lengths.empty()) return {H5Screate(H5S_SCALAR), H5Sclose};
  const std::vector<hsize_t> sizes(lengths.begin(), lengths.end());
  return {H5Screate_simple(static_cast<int>(sizes.size()), sizes.data(), nullptr), H5Sclose};
}

/// Texts of `bytes` bytes, padded with zeros, UTF-8.
Handle textType(std::size_t bytes) {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type, std::max<std::size_t>(1, bytes));
  H5Tset_strpad(type, H5T_STR_NULLPAD);
  H5Tset_cset(type, H5T_CSET_UTF8);
  return {H5Tcopy(type), H5Tclose};
}

bool writeSet(hid_t file, const std::string& name, hid_t stored, hid_t inMemory, const void* values,
              const Lengths& lengths) {
  const Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose), creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  H5Pset_create_intermediate_group(links, 1);
  H5Pset_obj_track_times(creation, false);  // the same atlas is the same bytes
  const Handle space = spaceOf(lengths);
  const Handle set(H5Dcreate2(file, name.c_str(), stored, space, links, creation, H5P_DEFAULT), H5Dclose);
  const bool empty = std::find(lengths.begin(), lengths.end(), 0u) != lengths.end();
  return set.valid() && (empty || H5Dwrite(set, inMemory, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) >= 0);
}

bool writeAttribute(hid_t file, const std::string& name, hid_t type, const void* value) {
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const Handle attribute(H5Acreate2(file, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  return attribute.valid() && H5Awrite(attribute, type, value) >= 0;
}

/// In memory nothing of this can fail but for want of it.
void require(bool done) {
  if (!done) throw std::runtime_error("HDF5 could not put an array together");
}

}  // namespace

Hdf5Writer::Hdf5Writer(const std::filesystem::path& file) : file_(file) {
  keepHdf5Quiet();
  const Handle creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose), access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  H5Pset_userblock(creation, kSealBytes);
  H5Pset_fapl_core(access, kGrowth, false);
  handle_ = H5Fcreate(file.c_str(), H5F_ACC_TRUNC, creation, access);
  require(handle_ >= 0);
}

Hdf5Writer::~Hdf5Writer() {
  if (handle_ >= 0) H5Fclose(handle_);
}

void Hdf5Writer::numbers(const std::string& name, const double* values, const Lengths& lengths) {
  require(writeSet(handle_, name, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, values, lengths));
}

void Hdf5Writer::integers(const std::string& name, const std::vector<std::int32_t>& values,
                          const Lengths& lengths) {
  require(writeSet(handle_, name, H5T_STD_I32LE, H5T_NATIVE_INT32, values.data(), lengths));
}

void Hdf5Writer::texts(const std::string& name, const std::vector<std::string>& values) {
  std::size_t longest = 1;
  for (const std::string& value : values) longest = std::max(longest, value.size());
  std::string all;
  for (const std::string& value : values) all += value + std::string(longest - value.size(), '\0');
  const Handle type = textType(longest);
  require(writeSet(handle_, name, type, type, all.data(), {values.size()}));
}

void Hdf5Writer::text(const std::string& name, const std::string& value) {
  const Handle type = textType(value.size());
  require(writeSet(handle_, name, type, type, value.empty() ? "\0" : value.data(), {}));
}

void Hdf5Writer::attribute(const std::string& name, std::int32_t value) {
  require(writeAttribute(handle_, name, H5T_NATIVE_INT32, &value));
}
void Hdf5Writer::attribute(const std::string& name, double value) {
  require(writeAttribute(handle_, name, H5T_NATIVE_DOUBLE, &value));
}
void Hdf5Writer::attribute(const std::string& name, const std::string& value) {
  const Handle type = textType(value.size());
  require(writeAttribute(handle_, name, type, value.empty() ? "\0" : value.data()));
}

void Hdf5Writer::close() {
  require(H5Fflush(handle_, H5F_SCOPE_GLOBAL) >= 0);
  const ssize_t size = H5Fget_file_image(handle_, nullptr, 0);
  require(size > 0);
  // The image lacks the room for the seal that all places in it count from.
  std::vector<char> image(kSealBytes + static_cast<std::size_t>(size), ' ');
  require(H5Fget_file_image(handle_, image.data() + kSealBytes, static_cast<std::size_t>(size)) == size);
  H5Fclose(handle_);
  handle_ = -1;
  std::ofstream stream(file_, std::ios::binary | std::ios::trunc);
  stream.write(image.data(), static_cast<std::streamsize>(image.size()));
  stream.close();
  if (!stream)
    throw InputError("cannot write '" + file_.string() + "'; is the disk full, or the folder not yours?");
}

/// One array, opened and its shape known.
class Hdf5Reader::Opened {
 public:
  Opened(const Hdf5Reader& reader, const std::string& name, H5T_class_t kind)
      : set_(H5Dopen2(reader.handle_, name.c_str(), H5P_DEFAULT), H5Dclose),
        space_(set_.valid() ? H5Dget_space(set_) : -1, H5Sclose),
        type_(set_.valid() ? H5Dget_type(set_) : -1, H5Tclose) {
    if (!space_.valid() || !type_.valid()) reader.fail(name, "is missing");
    if (H5Tget_class(type_) != kind || (kind == H5T_STRING && H5Tis_variable_str(type_) > 0))
      reader.fail(name, "is of another type than this program writes");
    std::vector<hsize_t> sizes(static_cast<std::size_t>(std::max(0, H5Sget_simple_extent_ndims(space_))));
    H5Sget_simple_extent_dims(space_, sizes.data(), nullptr);
    lengths_.assign(sizes.begin(), sizes.end());
    // Our arrays are not compressed: one that claims more than its file holds is not ours.
    const std::uint64_t size = H5Tget_size(type_);
    count_ = 1;
    for (const std::uint64_t length : lengths_) {
      if (length > 0 && count_ > reader.bytes_ / length)
        reader.fail(name, "claims to be larger than the file");
      count_ *= length;
    }
    if (size > 0 && count_ > reader.bytes_ / size) reader.fail(name, "claims to be larger than the file");
  }

  void expect(const Hdf5Reader& reader, const std::string& name, Lengths& lengths) const {
    bool same = lengths.size() == lengths_.size();
    for (std::size_t d = 0; same && d < lengths.size(); ++d)
      same = lengths[d] == kAny || lengths[d] == lengths_[d];
    if (!same) reader.fail(name, "is of another size than the rest");
    lengths = lengths_;
  }

  void read(const Hdf5Reader& reader, const std::string& name, hid_t inMemory, void* to) const {
    if (count_ > 0 && H5Dread(set_, inMemory, H5S_ALL, H5S_ALL, H5P_DEFAULT, to) < 0)
      reader.fail(name, "cannot be read");
  }

  [[nodiscard]] std::uint64_t count() const { return count_; }
  [[nodiscard]] hid_t type() const { return type_; }

 private:
  Handle set_, space_, type_;
  Lengths lengths_;
  std::uint64_t count_ = 0;
};

Hdf5Reader::Hdf5Reader(const std::filesystem::path& file) : file_(file) {
  keepHdf5Quiet();
  std::error_code error;
  bytes_ = std::filesystem::file_size(file, error);
  handle_ = error ? -1 : H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  if (handle_ < 0) throw InputError("'" + file.string() + "' cannot be read as HDF5; build it anew");
}

Hdf5Reader::~Hdf5Reader() {
  if (handle_ >= 0) H5Fclose(handle_);
}

void Hdf5Reader::fail(const std::string& name, const std::string& why) const {
  throw InputError("'" + file_.string() + "': the array '" + name + "' " + why + "; build the file anew");
}

std::vector<double> Hdf5Reader::numbers(const std::string& name, Lengths& lengths) const {
  const Opened opened(*this, name, H5T_FLOAT);
  opened.expect(*this, name, lengths);
  std::vector<double> values(opened.count());
  opened.read(*this, name, H5T_NATIVE_DOUBLE, values.data());
  return values;
}

std::vector<std::int32_t> Hdf5Reader::integers(const std::string& name, Lengths& lengths) const {
  const Opened opened(*this, name, H5T_INTEGER);
  opened.expect(*this, name, lengths);
  std::vector<std::int32_t> values(opened.count());
  opened.read(*this, name, H5T_NATIVE_INT32, values.data());
  return values;
}

std::vector<std::string> Hdf5Reader::texts(const std::string& name, std::uint64_t count) const {
  const Opened opened(*this, name, H5T_STRING);
  Lengths lengths{count};
  opened.expect(*this, name, lengths);
  const std::size_t width = H5Tget_size(opened.type());
  std::string all(width * opened.count(), '\0');
  opened.read(*this, name, opened.type(), all.data());
  std::vector<std::string> values;
  for (std::uint64_t k = 0; k < count; ++k) {
    std::string value = all.substr(k * width, width);
    value.resize(std::min(value.size(), value.find('\0')));
    values.push_back(std::move(value));
  }
  return values;
}

std::string Hdf5Reader::text(const std::string& name) const {
  const Opened opened(*this, name, H5T_STRING);
  Lengths scalar;
  opened.expect(*this, name, scalar);
  std::string value(H5Tget_size(opened.type()), '\0');
  opened.read(*this, name, opened.type(), value.data());
  value.resize(std::min(value.size(), value.find('\0')));
  return value;
}

double Hdf5Reader::numberAttribute(const std::string& name) const {
  const Handle attribute(H5Aopen(handle_, name.c_str(), H5P_DEFAULT), H5Aclose);
  const Handle space(attribute.valid() ? H5Aget_space(attribute) : -1, H5Sclose);
  double value = 0;
  if (!space.valid() || H5Sget_simple_extent_npoints(space) != 1 ||
      H5Aread(attribute, H5T_NATIVE_DOUBLE, &value) < 0)
    fail(name, "is missing");
  return value;
}

}  // namespace falciform
