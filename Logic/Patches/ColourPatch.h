#pragma once
#include <string>
#include <vector>

#include "Logic/Core/Settings.h"
#include "Logic/Core/Surface.h"

namespace falciform {

/// How a roughly painted patch is fitted to what the camera saw.
struct ColourPatchSettings {
  double reachMm = 12;    ///< the border may move so far outwards from the rough patch
  double smoothness = 4;  ///< how much neighbours of one colour hold together, against each one's own colour
  int rounds = 5;         ///< at most so many times colours are learnt anew
  double leastContrast =
      1.5;  ///< standard deviations between inside and outside, below which colour tells nothing
};

template <class Visitor>
void describe(ColourPatchSettings& s, Visitor&& field) {
  field(FieldInfo{"reachMm", "Reach", "mm", 1, 60, "The border may move so far from the rough patch."},
        s.reachMm);
  field(FieldInfo{"smoothness", "Smoothness", "", 0, 100,
                  "How much neighbours of one colour hold together, against each one's own colour."},
        s.smoothness);
  field(FieldInfo{"rounds", "Rounds", "", 1, 20, "At most so many times the colours are learnt anew."},
        s.rounds);
  field(
      FieldInfo{
          "leastContrast", "Least contrast", "", 0, 10,
          "Standard deviations between the colours inside and outside, below which the patch is left alone."},
      s.leastContrast);
}

struct ColourPatch {
  std::vector<int> vertices;  ///< of the refined patch, ascending
  double contrast = 0;        ///< between inside and outside, standard deviations
  int rounds = 0;
  bool refined = false;  ///< false: colour tells nothing, and the patch is as it was
  std::vector<std::string> warnings;
};

/// GrabCut (Rother, Kolmogorov, Blake 2004) over the surface itself in place of a picture, with a random
/// walker (Grady 2006) in place of the cut: colours inside and outside are learnt from the patch as it
/// stands, each vertex near it is given to one or the other by its colour and its neighbours', and so on
/// until nothing changes. A cloud's neighbours are its nearest points. The pieces that touch the rough patch
/// stay. Throws InputError for a surface without colours, or a label that is painted nowhere or everywhere.
[[nodiscard]] ColourPatch refinePatchByColour(const Surface& surface, int label,
                                              const ColourPatchSettings& settings = {});

}  // namespace falciform
