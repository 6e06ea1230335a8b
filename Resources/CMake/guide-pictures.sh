#!/usr/bin/env bash
# guide-pictures.sh BUILD: draws the user guide's pictures of the window and of the demo anew, from the built-in case and
# synthetic ones, into Docs/UserGuide/pictures. Called by `./run docs`.
set -euo pipefail
build=$1
work=.build/guide
into=Docs/UserGuide/pictures
falciform=$build/bin/falciform
mkdir -p "$work"

# window FOLDER ARG...: WindowPictures on a display of its own.
window() {
  local folder=$1
  shift
  rm -rf "$folder" && mkdir -p "$folder"
  xvfb-run -a -s "-screen 0 1280x800x24" env LIBGL_ALWAYS_SOFTWARE=1 "$build/bin/WindowPictures" "$folder" "$@" >"$folder/log.txt" 2>&1 ||
    { tail -5 "$folder/log.txt" >&2; exit 1; }
}

# take FOLDER NAME=PICTURE...: copies FOLDER/PICTURE.png as NAME.png.
take() {
  local folder=$1 pair
  shift
  for pair in "$@"; do
    cp "$folder/${pair#*=}.png" "$into/${pair%%=*}.png"
    echo "$into/${pair%%=*}.png"
  done
}

# painted CASE: the case opens painted and in its true pose.
painted() {
  python3 - "$1" <<'PY'
import json, sys
file = sys.argv[1] + "/case.json"
case = json.load(open(file))
for key in ("labelMap", "labels", "preopPatches"): case.pop(key, None)
case["preop"] = "preop_painted.vtp"
case["registration"] = "truth_scan_from_preop.tfm"
json.dump(case, open(file, "w"), indent=2)
PY
}

"$falciform" demo --out "$work/demo" --force >"$work/demo.txt"
pictures=$work/demo/results/pictures
for name in preop after distance_scan histogram update update_ct; do
  if [ -f "$pictures/$name.png" ]; then take "$pictures" "$name=$name"; fi
done
case=$work/demo/case
window "$work/segment" --only SegmentationImport "$case/ct.nii.gz"
take "$work/segment" window_segment_seeds=SegmentationImport_seeds window_segment_front=SegmentationImport_front \
  window_segment_mended=SegmentationImport_mended window_import=SegmentationImport_preview
window "$work/steps" "$case"/{preop_painted.vtp,scan.vtp,preop_landmarks.mrk.json,scan_landmarks.mrk.json,ct.nii.gz} "$case"/structures/*.vtp
take "$work/steps" window_paint_liver=PatchPainting_liver window_paint_line=PatchPainting_line window_paint_scan=PatchPainting \
  window_registration=Registration window_registration_result=Registration_result window_registration_poses=Registration_poses \
  window_registration_by_hand=Registration_by_hand window_supports_painted=AtlasUpdate_supports window_supports_packed=AtlasUpdate_packed \
  window_keys=Desktop_keys window_dark=Desktop_dark

"$falciform" synthesise --packing 20 --edge-length 3 --voxel 2 --out "$work/packed" --force >/dev/null
painted "$work/packed"
window "$work/update" --only AtlasUpdate "$work/packed"
take "$work/update" window_update_settling=AtlasUpdate_settling window_update_expected=AtlasUpdate_expected_error \
  window_update_compared=AtlasUpdate_all window_update_scan_next=AtlasUpdate_scan_next

# A scan of a busy room, raw.
"$falciform" synthesise --drape --instruments 3 --smoke 0.01 --baseline 150 --dropout 0.3 --photograph --out "$work/room" --force >/dev/null
window "$work/scan" --only ScanPreparation "$work/room/scan_raw.vtp"
take "$work/scan" window_scan=ScanPreparation

# Seven cases of two kinds beside each other.
rm -rf "$work/cases" && mkdir -p "$work/cases"
for seed in 1 2 3 4 5 6 7; do
  bend="--deformation $((5 + seed))"
  [ "$seed" -gt 4 ] && bend="--packing $((9 + seed))"
  # shellcheck disable=SC2086  # two words
  "$falciform" synthesise --variation 0.12 --edge-length 2.5 --voxel 3 --stride 4 --seed "$seed" $bend --out "$work/cases/case_$seed" >/dev/null
  painted "$work/cases/case_$seed"
done
window "$work/distances" --only DeformationAnalysis --compare "$work/cases" "$work/cases/case_1"
take "$work/distances" window_distance=DeformationAnalysis window_distance_threshold=DeformationAnalysis_threshold \
  window_distance_cases=DeformationAnalysis_cases
echo "guide-pictures.sh: the other pictures are of the commands on their own pages"
