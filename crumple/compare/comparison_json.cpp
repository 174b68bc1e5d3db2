// SPDX-License-Identifier: BSD-3-Clause
#include "compare/comparison_json.hpp"

#include <nlohmann/json.hpp>

namespace crumple::compare {

namespace {

using Json = nlohmann::ordered_json;

Json side(const CurveSet& set) {
  return {{"source", set.source}, {"files", set.files}, {"curves", set.curves.size()}, {"notes", set.notes}};
}

/// What can be said of a curve without scores.
Json description(const ComparedCurve& curve) {
  Json json = {{"name", name_of(curve.reference)},
               {"group", curve.reference.group},
               {"quantity", curve.reference.quantity},
               {"item", curve.reference.item}};
  if (name_of(curve.other) != name_of(curve.reference)) json["other_name"] = name_of(curve.other);
  json.update({{"start", curve.start},
               {"end", curve.end},
               {"peak", curve.peak},
               {"difference", curve.difference},
               {"time", curve.time},
               {"relative", curve.relative}});
  if (curve.inside_band) json["inside_band"] = *curve.inside_band;
  return json;
}

Json scores(const ComparedCurve& curve) {
  const IsoRating& rating = curve.rating;
  return {{"samples", curve.samples},
          {"interval", (curve.end - curve.start) / static_cast<double>(curve.samples - 1)},
          {"sprague_geers",
           {{"magnitude", curve.errors.magnitude},
            {"phase", curve.errors.phase},
            {"combined", curve.errors.combined}}},
          {"iso_18571",
           {{"corridor", rating.corridor},
            {"phase", rating.phase},
            {"magnitude", rating.magnitude},
            {"slope", rating.slope},
            {"rating", rating.rating},
            {"grade", grade_of(rating.rating)},
            {"shift_samples", rating.shift}}}};
}

}  // namespace

Json comparison_json(const Comparison& comparison, const CurveSet& reference, const CurveSet& other,
                     const ComparisonSettings& settings) {
  Json json = {{"format", 1}, {"reference", side(reference)}, {"other", side(other)}};
  json["cfc"] = settings.cfc == 0 ? Json() : Json(settings.cfc);
  json["floor"] = settings.floor;
  json["curves"] = Json::array();
  for (const ComparedCurve& curve : comparison.curves) {
    json["curves"].push_back(description(curve));
    json["curves"].back().update(scores(curve));
  }
  json["not_rated"] = Json::array();
  for (const ComparedCurve& curve : comparison.negligible) json["not_rated"].push_back(description(curve));
  json["only_in_reference"] = comparison.only_reference;
  json["only_in_other"] = comparison.only_other;
  json["notes"] = comparison.notes;
  return json;
}

}  // namespace crumple::compare
