#include <chrono>

#include "Logic/Atlas/AtlasFiles.h"
#include "Logic/Atlas/KeptSolves.h"
#include "Logic/Atlas/LoadFiles.h"
#include "Logic/Core/Parallel.h"
#include "Modules/CommandLine/AtlasFigures.h"
#include "Modules/CommandLine/BuildShare.h"
#include "Modules/CommandLine/Commands.h"
#include "Modules/CommandLine/DesignInput.h"
#include "Modules/CommandLine/Figures.h"
#include "Modules/CommandLine/LiverInput.h"
#include "Version.h"

namespace falciform::commandline {

namespace fs = std::filesystem;

namespace {

void declare(Syntax& syntax) {
  using enum ArgumentKind;
  const std::string group = "Files";
  declareLiverInput(syntax, group);
  syntax.add({.name = "out",
              .kind = File,
              .label = "Atlas",
              .help = "Atlas to write, .h5; its sidecar is written beside it as FILE.json.",
              .required = true,
              .output = true,
              .group = group});
  syntax.add({.name = "shard",
              .kind = Text,
              .label = "Part of the work",
              .help = "Do part K/N of the solves (K from 0), beside other processes with the same arguments; "
                      "whoever ends last writes the atlas. mpirun needs no --shard.",
              .group = "Sharing"});
  syntax.addSettings(MeshSettings{}, "Mesh, where none is given");
  syntax.add({.name = "DESIGN",
              .kind = Text,
              .label = "Design",
              .help = "JSON file that says which deformations, or a preset: " + atlasPresetsText() + ".",
              .required = true,
              .positional = true,
              .group = group});
  for (const ResultField& field : atlasResultFields()) syntax.addResult(field);
}

/// Whether `file` holds what this job would build.
bool isBuilt(const fs::path& file, const AtlasJob& job) {
  try {
    const Atlas there = readAtlas(file).atlas;
    return toJson(there.design) == toJson(job.design) && there.mesh.points.rows() == job.mesh.points.rows() &&
           there.mesh.points == job.mesh.points;
  } catch (const InputError&) {
    return false;
  }
}

/// One process's part of a build.
class Build {
 public:
  Build(const ParsedArguments& arguments, CommandRun& run)
      : run_(run), out_(arguments.path("out")), share_(buildShare(arguments.text("shard"))) {
    if (out_.extension() != ".h5")
      throw InputError("--out is '" + out_.string() + "'; an atlas is written as .h5");
    results_.overwrite = run.outputs.overwrite;
    if (!share_.shared()) announce();
  }

  /// Surface loads share one factorisation: there is nothing to divide, and nothing to go on from.
  void executeLoads(const TetrahedralMesh& mesh, const AtlasDesign& design) {
    if (share_.shared())
      throw InputError("surface loads are solved by one process; leave --shard and mpirun out");
    const auto began = std::chrono::steady_clock::now();
    const LoadAtlas atlas = buildLoadAtlas(mesh, design, run_.progress.part(0.3, 0.95));
    run_.figures["solve_s"] = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    run_.progress.report(0.95, "Writing");
    run_.figures.update(loadFigures(atlas));
    write(design, mesh.frame,
          [&](const fs::path& file) { writeLoadAtlas(file, atlas, toJson(run_.provenance)); });
    for (const std::string& line : loadLines(atlas)) run_.say(line);
  }

  void execute(AtlasJob job) {
    std::error_code error;
    const bool anew = results_.overwrite == Overwrite::Replace;
    if (share_.shared() && !anew && fs::exists(out_, error)) {
      if (!isBuilt(out_, job)) announce();  // says that it exists
      run_.say(out_.string() + " is built already");
      return;
    }
    KeptSolves kept(out_.string() + ".part", basisOf(job, kVersion), job);
    kept.open(anew);
    fields_.resize(job.solves.batches.size());
    try {
      solve(job, kept);
      finish(job, kept);
    } catch (const Cancelled&) {
      if (kept.count() > 0)
        throw Interrupted("cancelled; " + std::to_string(kept.count()) + " of " +
                          std::to_string(job.solves.solves.size()) + " solves are kept in '" +
                          kept.folder().string() + "', and the same command goes on from there");
      kept.remove();
      throw;
    } catch (...) {
      if (kept.count() == 0) kept.remove();
      throw;
    }
  }

 private:
  void announce() {
    results_.announce(out_);
    results_.announce(sidecarOf(out_));
  }

  void solve(const AtlasJob& job, KeptSolves& kept) {
    std::vector<int> missing;
    for (const int batch : share_.of(static_cast<int>(job.solves.batches.size())))
      if (!kept.has(batch)) missing.push_back(batch);
    if (const int earlier = kept.count(); earlier > 0 && !share_.shared())
      run_.say("continued: " + std::to_string(earlier) + " of " + std::to_string(job.solves.solves.size()) +
               " solves were done before");
    const auto began = std::chrono::steady_clock::now();
    solveBatches(
        job.mesh, job.design, job.members, job.solves, missing,
        [&](int batch, std::vector<Points> fields) {
          kept.keep(batch, fields);
          fields_[static_cast<std::size_t>(batch)] = std::move(fields);
        },
        run_.progress.part(0.3, 0.85));
    run_.figures["solve_s"] = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  }

  void finish(const AtlasJob& job, KeptSolves& kept) {
    std::optional<KeptSolves::Turn> turn;
    if (share_.shared()) {
      turn.emplace(kept);
      std::error_code error;
      if (!fs::exists(kept.folder(), error)) {
        run_.say(out_.string() + " was written by another process");
        return;
      }
      for (std::size_t b = 0; b < fields_.size(); ++b)
        if (fields_[b].empty() && !kept.has(static_cast<int>(b))) {
          run_.say(std::to_string(kept.count()) + " of " + std::to_string(job.solves.solves.size()) +
                   " solves are kept in '" + kept.folder().string() + "'; whoever ends last writes " +
                   out_.string());
          return;
        }
      announce();
    }
    std::vector<Points> solved;
    for (std::size_t b = 0; b < fields_.size(); ++b) {
      std::vector<Points> batch = fields_[b].empty() ? kept.read(static_cast<int>(b)) : std::move(fields_[b]);
      std::move(batch.begin(), batch.end(), std::back_inserter(solved));
    }
    const auto began = std::chrono::steady_clock::now();
    const Atlas atlas = assembleAtlas(job, solved, run_.progress.part(0.85, 0.98));
    run_.progress.report(0.98, "Writing");
    run_.figures.update(atlasFigures(atlas));
    run_.figures["compress_s"] =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    run_.warn(atlasWarnings(atlas));
    write(atlas.design, atlas.mesh.frame,
          [&](const fs::path& file) { writeAtlas(file, atlas, toJson(run_.provenance)); });
    kept.remove();
    for (const std::string& line : atlasLines(atlas)) run_.say(line);
  }

  /// The atlas by `writer`, and its sidecar.
  template <class Writer>
  void write(const AtlasDesign& design, const std::string& frame, const Writer& writer) {
    run_.settings["design"] = toJson(design);
    run_.frames[out_.filename().string()] = frame == "LPS" ? "patient LPS, mm" : frame + ", mm";
    writer(results_.staged(out_));
    writeTextFile(results_.staged(sidecarOf(out_)), Overwrite::Replace, run_.sidecar().dump(2) + "\n");
    results_.commit();
    run_.say(out_.string() + ":");
  }

  CommandRun& run_;
  fs::path out_;
  BuildShare share_;
  Outputs results_;                          ///< its own: they appear while this process has its turn
  std::vector<std::vector<Points>> fields_;  ///< of the batches solved here
};

void execute(const ParsedArguments& arguments, CommandRun& run) {
  if (arguments.integer("threads") == 0) shareThreads();
  run.provenance.threads = threads();
  Build build(arguments, run);
  const AtlasDesign design = readDesign(arguments.text("DESIGN"), run);
  const auto began = std::chrono::steady_clock::now();
  const LiverInput liver = readLiverInput(arguments, run, run.progress.part(0, 0.28));
  run.figures["mesh_s"] = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  if (design.kind == AtlasKind::SurfaceLoads) {
    build.executeLoads(liver.mesh, design);
    return;
  }
  const BoundaryFaces faces = boundaryFaces(liver.mesh);
  const SupportSites sites = findSupportSites(liver.surface, liver.mesh, faces);
  run.warn(sites.warnings);
  build.execute(prepareAtlas(liver.mesh, sites, design));
}

}  // namespace

Command atlasBuildCommand() {
  return {"atlas build", "Deformation atlas",
          "Solves a design of deformations on a liver and keeps them as few modes.", declare, execute};
}

}  // namespace falciform::commandline
