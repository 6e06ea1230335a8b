#include "Logic/Atlas/KeptSolves.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <fstream>
#include <sstream>

#include "Logic/Atlas/Hdf5Store.h"
#include "Logic/Atlas/SealedFile.h"
#include "Logic/Core/Errors.h"

namespace falciform {
namespace fs = std::filesystem;
namespace {

constexpr char kKind[] = "falciform solves";
constexpr int kVersion = 1;

/// The entry in which the two differ, or empty.
std::string difference(const nlohmann::json& now, const nlohmann::json& then) {
  if (!then.is_object()) return "format";
  for (const auto& [key, value] : now.items())
    if (!then.contains(key) || then.at(key) != value) return key;
  return "";
}

/// Written under a name of this process and moved to its place: others see all of it or nothing.
void writeWhole(const fs::path& file, const std::function<void(const fs::path&)>& write) {
  const fs::path temporary = file.string() + "." + std::to_string(getpid());
  std::error_code error;
  try {
    write(temporary);
    fs::rename(temporary, file, error);
    if (error) throw InputError("cannot write '" + file.string() + "': " + error.message());
  } catch (...) {
    fs::remove(temporary, error);
    throw;
  }
}

/// A folder that a process has just made, and nothing else.
bool nothingButTurn(const fs::path& folder) {
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
    if (entry.path().filename() != "turn") return false;
  return true;
}

}  // namespace

nlohmann::json basisOf(const AtlasJob& job, const std::string& programVersion) {
  Checksum mesh, supports;
  mesh.addRange(job.mesh.points.data(), static_cast<std::size_t>(job.mesh.points.size()));
  mesh.addRange(job.mesh.elements.data(), static_cast<std::size_t>(job.mesh.elements.size()));
  mesh.addRange(job.mesh.regions.data(), job.mesh.regions.size());
  for (const AtlasSetup& setup : job.members.setups)
    for (const Support& support : setup.supports) {
      const std::size_t head[] = {static_cast<std::size_t>(support.kind), support.faces.size()};
      supports.addRange(head, 2);
      supports.addRange(support.faces.data(), support.faces.size());
    }
  return {{"program", programVersion},
          {"design", toJson(job.design)},
          {"mesh", mesh.text()},
          {"supports", supports.text()}};
}

KeptSolves::KeptSolves(fs::path folder, nlohmann::json basis, const AtlasJob& job)
    : folder_(std::move(folder)),
      basis_(std::move(basis)),
      batches_(job.solves.batches),
      nodes_(job.mesh.nodes()) {
  Checksum sum;
  const std::string text = basis_.dump();
  sum.add(text.data(), text.size());
  digest_ = sum.text();
}

fs::path KeptSolves::fileOf(int batch) const { return folder_ / ("solves-" + std::to_string(batch) + ".h5"); }

void KeptSolves::open(bool anew) {
  const Turn turn(*this);
  std::error_code error;
  if (!fs::exists(folder_, error)) return;
  std::ifstream stream(basisFile());
  std::stringstream text;
  text << stream.rdbuf();
  const nlohmann::json then = stream ? nlohmann::json::parse(text.str(), nullptr, false) : nlohmann::json();
  const std::string differs = difference(basis_, then);
  if (differs.empty()) return;
  if (!stream && nothingButTurn(folder_)) return;
  if (!anew)
    throw InputError("'" + folder_.string() + "' is of an interrupted build with another " + differs +
                     "; repeat that command, choose another --out or begin anew with --force");
  remove();
}

void KeptSolves::writeBasis() const {
  std::error_code error;
  if (fs::exists(basisFile(), error)) return;
  fs::create_directories(folder_, error);
  writeWhole(basisFile(), [&](const fs::path& temporary) {
    std::ofstream stream(temporary);
    stream << basis_.dump(2) << '\n' << std::flush;
    if (!stream)
      throw InputError("cannot write into '" + folder_.string() +
                       "'; is the disk full, or the folder not yours?");
  });
}

void KeptSolves::keep(int batch, const std::vector<Points>& fields) {
  writeBasis();
  writeWhole(fileOf(batch), [&](const fs::path& temporary) {
    std::vector<double> all;
    for (const Points& field : fields) all.insert(all.end(), field.data(), field.data() + field.size());
    Hdf5Writer file(temporary);
    file.text("basis", digest_);
    file.numbers("displacement_mm", all.data(), {fields.size(), static_cast<std::uint64_t>(nodes_), 3});
    file.close();
    sealFile(temporary, kKind, kVersion);
  });
}

std::vector<Points> KeptSolves::read(int batch) const {
  const fs::path path = fileOf(batch);
  checkSeal(path, kKind, kVersion);
  const Hdf5Reader file(path);
  if (file.text("basis") != digest_)
    throw InputError("'" + path.string() +
                     "' is of another build; choose another --out or begin anew with --force");
  const AtlasSolves::Batch& wanted = batches_[static_cast<std::size_t>(batch)];
  Lengths lengths{static_cast<std::uint64_t>(wanted.last - wanted.first), static_cast<std::uint64_t>(nodes_),
                  3};
  const std::vector<double> all = file.numbers("displacement_mm", lengths);
  std::vector<Points> fields;
  for (std::uint64_t k = 0; k < lengths[0]; ++k)
    fields.emplace_back(Eigen::Map<const Points>(all.data() + k * 3 * lengths[1], nodes_, 3));
  return fields;
}

bool KeptSolves::has(int batch) const {
  // A damaged one is solved again.
  const fs::path path = fileOf(batch);
  return sealFault(path, kKind, kVersion).empty() && Hdf5Reader(path).text("basis") == digest_;
}

int KeptSolves::count() const {
  int there = 0;
  std::error_code error;
  for (std::size_t b = 0; b < batches_.size(); ++b)
    if (fs::exists(fileOf(static_cast<int>(b)), error)) there += batches_[b].last - batches_[b].first;
  return there;
}

void KeptSolves::remove() const {
  std::error_code error;
  if (!fs::is_directory(folder_, error)) return;
  std::vector<fs::path> ours;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_, error)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with("solves-") || name.starts_with("build.json") || name == "turn")
      ours.push_back(entry.path());
  }
  for (const fs::path& file : ours) fs::remove(file, error);
  fs::remove(folder_, error);  // only if nothing else is in it
}

KeptSolves::Turn::Turn(const KeptSolves& kept) {
  std::error_code error;
  if (!fs::is_directory(kept.folder_, error)) return;  // done and gone
  descriptor_ = ::open(kept.lockFile().c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0666);
  if (descriptor_ >= 0) ::flock(descriptor_, LOCK_EX);
}

KeptSolves::Turn::~Turn() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

}  // namespace falciform
