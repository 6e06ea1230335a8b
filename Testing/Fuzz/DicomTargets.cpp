#include <gdcmTransferSyntax.h>

#include "Logic/Core/Errors.h"
#include "Logic/IO/VolumeFiles.h"
#include "Testing/Fuzz/FuzzTarget.h"
#include "Testing/Logic/IO/DicomBytes.h"
#include "Testing/Logic/IO/PackedSlice.h"

namespace falciform::test {

namespace {

template <class T>
void demandSound(const Volume<T>& volume) {
  demand(volume.voxels.size() == volume.offset(0, 0, volume.size.z()), "voxels are missing");
  demand(volume.worldFromIndex.allFinite() && volume.voxelVolume() > 0, "a geometry that cannot be");
}

/// All series that the mutant and the good slices beside it make; a mutant that is left out is refused.
void readSound(const std::filesystem::path& file) {
  const DicomListing listing = listDicom(file.parent_path());
  std::string refusal;
  for (const DicomSeries& series : listing.series) {
    const std::string words = describeSeries(series, 1);
    demand(!tellsIdentity(words), "the patient's name was told");
    for (const bool labels : {false, true}) {
      try {
        if (labels)
          demandSound(readDicomLabels(series).value);  // refused for a CT
        else
          demandSound(readDicomImage(series).value);
      } catch (const InputError& error) {
        demand(!tellsIdentity(error.what()), std::string("the patient's name was told: ") + error.what());
        if (!labels) refusal = error.what();
      }
    }
  }
  if (!listing.unreadable.empty()) refusal = listing.unreadable.front();
  demand(!tellsIdentity(refusal), "the patient's name was told: " + refusal);
  if (!refusal.empty()) throw InputError(refusal);
}

/// Two good slices beside the one that is changed.
FuzzTarget slices(const std::string& name, SlicePlan plan) {
  plan.values.resize(plan.coded.empty() ? plan.values.size() : 0);
  return {"dicom_" + name, "mutant",
          [plan](const std::filesystem::path& folder) {
            writeSeries(folder, plan, {0, 3});
            SlicePlan third = plan;
            third.position = "0\\0\\6";
            third.instance += ".77";
            return dicomSlice(third);
          },
          readSound};
}

}  // namespace

std::vector<FuzzTarget> dicomTargets() {
  using TS = gdcm::TransferSyntax;
  SlicePlan implicit, big, mask;
  implicit.syntax = DicomSyntax::ImplicitLittle;
  big.syntax = DicomSyntax::ExplicitBig;
  mask.intercept = "0";
  mask.values = {0, 1, 0, 1, 1, 1, 0, 0, 0, 0, 0, 1};
  std::vector<FuzzTarget> targets{
      slices("explicit", {}),
      slices("implicit", implicit),
      slices("big_endian", big),
      slices("mask", mask),
      slices("run_length", packedSlice(patternedSlice(12), TS::RLELossless)),
      slices("jpeg_lossless", packedSlice(patternedSlice(12), TS::JPEGLosslessProcess14_1)),
      slices("jpeg_lossless_8", packedSlice(patternedSlice(8), TS::JPEGLosslessProcess14_1)),
      slices("jpeg2000", packedSlice(patternedSlice(12), TS::JPEG2000Lossless)),
      slices("jpeg2000_16", packedSlice(patternedSlice(16), TS::JPEG2000Lossless))};
  targets.push_back({"dicom_segmentation", "mutant",
                     [](const std::filesystem::path&) { return dicomSegmentation(); },
                     [](const std::filesystem::path& file) {
                       const auto named = readNamedLabels(file);
                       demandSound(named.value.map);
                       for (const auto& [label, words] : named.value.names)
                         demand(!words.empty() || label >= 0, "a segment without a name");
                     }});
  return targets;
}

}  // namespace falciform::test
