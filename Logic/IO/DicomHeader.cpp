#include "Logic/IO/DicomHeader.h"

#include <algorithm>
#include <cmath>

#include "Logic/Core/Errors.h"
#include "Logic/IO/DicomWords.h"
#include "Logic/IO/HeaderText.h"

namespace falciform {

namespace {

using namespace dicomtag;

constexpr const char* kAgain = "; export it again";
constexpr int kMostFrames = 1 << 20;

int needShort(const DicomItem& data, DicomTag tag, const char* name) {
  const auto value = data.unsignedShort(tag);
  if (!value) throw InputError(std::string("it has no ") + name + kAgain);
  return *value;
}

DicomPixelFormat formatOf(const DicomFile& file) {
  const DicomItem& data = file.data;
  DicomPixelFormat format;
  format.rows = needShort(data, kRows, "number of rows");
  format.columns = needShort(data, kColumns, "number of columns");
  format.bitsAllocated = needShort(data, kBitsAllocated, "number of bits");
  format.bitsStored = data.unsignedShort(kBitsStored).value_or(format.bitsAllocated);
  format.highBit = data.unsignedShort(kHighBit).value_or(format.bitsStored - 1);
  format.isSigned = data.unsignedShort(kSigned).value_or(0) != 0;
  format.bigEndian = data.bigEndian;
  format.transferSyntax = file.transferSyntax;
  if (format.rows < 1 || format.columns < 1)
    throw InputError(std::string("its slices have no pixels") + kAgain);
  const int bits = format.bitsAllocated;
  if (bits != 1 && bits != 8 && bits != 16 && bits != 32)
    throw InputError("its pixels have " + std::to_string(bits) + " bits; export it with 8, 16 or 32");
  if (format.bitsStored < 1 || format.bitsStored > bits || format.highBit >= bits ||
      format.highBit + 1 < format.bitsStored)
    throw InputError("its pixels hold " + std::to_string(format.bitsStored) + " bits up to bit " +
                     std::to_string(format.highBit) + " of " + std::to_string(bits) + ", which cannot be" +
                     kAgain);
  if (data.unsignedShort(kSamples).value_or(1) != 1)
    throw InputError("its pixels are colours; give a series with one number a pixel");
  const std::string_view photometric = data.text(kPhotometric);
  if (photometric != "MONOCHROME1" && photometric != "MONOCHROME2" && !photometric.empty())
    throw InputError("its pixels are colours; give a series with one number a pixel");
  return format;
}

/// The functional group `sequence` of a frame, its own or the one that all frames share.
const DicomItem* group(const DicomItem* own, const DicomItem* shared, DicomTag sequence) {
  for (const DicomItem* groups : {own, shared})
    if (groups)
      if (const DicomItem* found = groups->first(sequence)) return found;
  return nullptr;
}

/// In-plane geometry; `item` is the file's data set or a functional group.
bool readAxes(const DicomItem& item, DicomHeader& header) {
  const auto cosines = item.numbers(kOrientation, 6);
  if (!cosines) return false;
  header.axes.col(0) = Vector3d((*cosines)[0], (*cosines)[1], (*cosines)[2]);
  header.axes.col(1) = Vector3d((*cosines)[3], (*cosines)[4], (*cosines)[5]);
  return true;
}

bool readSpacing(const DicomItem& item, DicomHeader& header) {
  const auto spacing = item.numbers(kPixelSpacing, 2);  // between rows first (PS3.3, 10.7.1.3)
  if (!spacing) return false;
  header.spacingMm = {(*spacing)[1], (*spacing)[0]};
  return true;
}

bool readPosition(const DicomItem& item, DicomFrame& frame) {
  const auto place = item.numbers(kPosition, 3);
  if (!place) return false;
  frame.position = Vector3d((*place)[0], (*place)[1], (*place)[2]);
  return true;
}

void readScale(const DicomItem& item, DicomFrame& frame) {
  frame.slope = item.number(kSlope).value_or(frame.slope);
  frame.intercept = item.number(kIntercept).value_or(frame.intercept);
  if (frame.slope == 0) throw InputError(std::string("its rescale slope is 0") + kAgain);
}

[[noreturn]] void refuseNoPlace() {
  throw InputError(
      "its slices say neither where they lie in the patient nor how far apart their pixels are; "
      "give a series of slices, no survey or report");
}

void readSingle(const DicomItem& data, DicomHeader& header) {
  DicomFrame& frame = header.frames.emplace_back();
  if (!readAxes(data, header) || !readSpacing(data, header) || !readPosition(data, frame)) refuseNoPlace();
  readScale(data, frame);
  header.betweenSlicesMm = data.number(kBetweenSlices).value_or(0);
  header.thicknessMm = data.number(kThickness).value_or(0);
}

void readMulti(const DicomItem& data, int count, DicomHeader& header) {
  const DicomItem* shared = data.first(kSharedGroups);
  const DicomElement* perFrame = data.find(kFrameGroups);
  const std::size_t groups = perFrame ? perFrame->items.size() : 0;
  if (groups != static_cast<std::size_t>(count))
    throw InputError("it says that it has " + std::to_string(count) + " frames and describes " +
                     std::to_string(groups) + "; export it again as enhanced CT, DICOM SEG or single slices");
  bool haveAxes = false;
  for (const DicomItem& own : perFrame->items) {
    DicomFrame& frame = header.frames.emplace_back();
    const DicomItem* place = group(&own, shared, kPlanePosition);
    if (!place || !readPosition(*place, frame)) refuseNoPlace();
    if (const DicomItem* scale = group(&own, shared, kPixelTransformation)) readScale(*scale, frame);
    if (const DicomItem* segment = group(&own, shared, kSegmentIdentification))
      frame.segment = segment->unsignedShort(kReferencedSegment).value_or(0);
    const DicomItem* orientation = group(&own, shared, kPlaneOrientation);
    const DicomItem* measures = group(&own, shared, kPixelMeasures);
    DicomHeader read;
    if (!orientation || !measures || !readAxes(*orientation, read) || !readSpacing(*measures, read))
      refuseNoPlace();
    if (!haveAxes) {
      header.axes = read.axes;
      header.spacingMm = read.spacingMm;
      header.betweenSlicesMm = measures->number(kBetweenSlices).value_or(0);
      header.thicknessMm = measures->number(kThickness).value_or(0);
      haveAxes = true;
    } else if ((read.axes - header.axes).cwiseAbs().maxCoeff() > 1e-3 ||
               (read.spacingMm - header.spacingMm).cwiseAbs().maxCoeff() > 1e-4) {
      throw InputError("its frames lie in different directions; export each direction as its own series");
    }
  }
}

void checkPlane(DicomHeader& header) {
  const auto& axes = header.axes;
  const bool lengths = std::abs(axes.col(0).norm() - 1) < 1e-2 && std::abs(axes.col(1).norm() - 1) < 1e-2;
  if (!lengths || std::abs(axes.col(0).dot(axes.col(1))) > 1e-2)
    throw InputError(
        std::string("the directions of its rows and columns are no right angle of unit vectors") + kAgain);
  // Cosines are written with few digits; the pair nearest to them that is exactly orthonormal.
  header.axes.col(0).normalize();
  const Vector3d first = header.axes.col(0);
  header.axes.col(1) = (axes.col(1) - first * first.dot(axes.col(1))).normalized();
  for (const double spacing : {header.spacingMm.x(), header.spacingMm.y()})
    if (!(spacing > 1e-3 && spacing < 1e3))
      throw InputError("its pixels are " + shortText(spacing) + " mm apart, which cannot be" + kAgain);
  for (const DicomFrame& frame : header.frames)
    if (!(frame.position.cwiseAbs().maxCoeff() < 1e6))
      throw InputError("a slice lies " + shortText(frame.position.norm()) +
                       " mm from the origin, which cannot be" + kAgain);
}

void readSegments(const DicomItem& data, DicomHeader& header) {
  header.fractional = data.text(kSegmentationType) == "FRACTIONAL";
  header.labelMap = data.text(kSegmentationType) == "LABELMAP";
  header.maximumFraction = data.unsignedShort(kMaximumFraction).value_or(255);
  if (const DicomElement* segments = data.find(kSegments))
    for (const DicomItem& segment : segments->items)
      if (const auto number = segment.unsignedShort(kSegmentNumber))
        header.segments[*number] = plainWords(data, segment.text(kSegmentLabel));
}

}  // namespace

DicomHeader dicomHeader(const DicomFile& file) {
  const DicomItem& data = file.data;
  if (!data.find(kPixelData))
    throw InputError(
        "it holds no image (a report, a DICOMDIR or a plan); give the folder of a series of slices");
  DicomHeader header;
  header.format = formatOf(file);
  header.seriesDigest = digestOf(data.text(kSeries));
  header.instanceDigest = digestOf(data.text(kInstance));
  header.modality = codeWord(data.text(kModality));
  header.description = plainWords(data, data.text(kSeriesDescription));
  header.acquisition = data.number(kAcquisition).value_or(0);
  header.temporalPosition = data.number(kTemporalPosition).value_or(0);
  const std::string_view sopClass = data.text(kSopClass);
  header.segmentation = header.modality == "SEG" || sopClass.starts_with("1.2.840.10008.5.1.4.1.1.66.");
  const double frames = data.number(kFrames).value_or(1);
  if (!(frames >= 1 && frames <= kMostFrames))
    throw InputError("it says that it has " + shortText(frames) + " frames" + kAgain);
  if (data.find(kFrameGroups) || frames > 1)
    readMulti(data, static_cast<int>(frames), header);
  else
    readSingle(data, header);
  if (header.segmentation) readSegments(data, header);
  checkPlane(header);
  return header;
}

}  // namespace falciform
