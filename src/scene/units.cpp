#include "polhode/scene/units.hpp"

namespace polhode {
namespace {

rational decimal(const char* text) { return parse_rational(text); }

}  // namespace

ball pi_scale::at(precision p) const {
  ball result(factor, p);
  for (int i = 0; i < power; ++i) result = result * pi(p);
  for (int i = 0; i > power; --i) result = result / pi(p);
  return result;
}

const std::vector<unit>& length_units() {
  static const std::vector<unit> units{
      {"m", {1, 0}},     {"cm", {decimal("0.01"), 0}},   {"mm", {decimal("0.001"), 0}},
      {"km", {1000, 0}}, {"in", {decimal("0.0254"), 0}}, {"ft", {decimal("0.3048"), 0}}};
  return units;
}

const std::vector<unit>& mass_units() {
  static const std::vector<unit> units{{"kg", {1, 0}},
                                       {"g", {decimal("0.001"), 0}},
                                       {"t", {1000, 0}},
                                       {"lb", {decimal("0.45359237"), 0}},
                                       {"oz", {decimal("0.028349523125"), 0}}};
  return units;
}

const std::vector<unit>& density_units() {
  static const std::vector<unit> units{{"kg/m^3", {1, 0}}, {"g/cm^3", {1000, 0}}};
  return units;
}

// The pound is 0.45359237 kg, the ounce its sixteenth, the foot 0.3048 m; the slug is the mass that
// a pound of force, 0.45359237 kg times 9.80665 m/s^2, accelerates by 1 ft/s^2. The unified atomic
// mass unit has the value of CODATA 2022, whose uncertainty of 5.2e-37 kg is not counted.
const std::vector<unit>& inertia_units() {
  static const std::vector<unit> units = [] {
    const rational pound = decimal("0.45359237");
    const rational foot = decimal("0.3048");
    const rational inch(foot / 12);
    const rational dalton = decimal("1.66053906892e-27");
    return std::vector<unit>{{"kg m^2", {1, 0}},
                             {"kg cm^2", {decimal("1e-4"), 0}},
                             {"kg mm^2", {decimal("1e-6"), 0}},
                             {"g m^2", {decimal("1e-3"), 0}},
                             {"g cm^2", {decimal("1e-7"), 0}},
                             {"g mm^2", {decimal("1e-9"), 0}},
                             {"lb ft^2", {pound * foot * foot, 0}},
                             {"lb in^2", {pound * inch * inch, 0}},
                             {"oz in^2", {pound / 16 * inch * inch, 0}},
                             {"slug ft^2", {pound * decimal("9.80665") * foot, 0}},
                             {"u A^2", {dalton * decimal("1e-20"), 0}},
                             {"u Å^2", {dalton * decimal("1e-20"), 0}}};
  }();
  return units;
}

const std::vector<unit>& momentum_units() {
  static const std::vector<unit> units{
      {"kg m^2/s", {1, 0}}, {"N m s", {1, 0}}, {"g cm^2/s", {decimal("1e-7"), 0}}};
  return units;
}

const std::vector<unit>& time_units() {
  static const std::vector<unit> units{{"s", {1, 0}},
                                       {"ms", {decimal("1e-3"), 0}},
                                       {"us", {decimal("1e-6"), 0}},
                                       {"ns", {decimal("1e-9"), 0}},
                                       {"ps", {decimal("1e-12"), 0}},
                                       {"min", {60, 0}},
                                       {"h", {3600, 0}},
                                       {"day", {86400, 0}},
                                       {"year", {31557600, 0}}};  // of 365.25 days
  return units;
}

const std::vector<unit>& angle_units() {
  static const std::vector<unit> units{{"rad", {1, 0}},
                                       {"mrad", {decimal("1e-3"), 0}},
                                       {"deg", {rational(1, 180), 1}},
                                       {"arcmin", {rational(1, 180 * 60), 1}},
                                       {"arcsec", {rational(1, 180 * 3600), 1}},
                                       {"rev", {2, 1}}};
  return units;
}

const std::vector<unit>& rotational_units() {
  static const std::vector<unit> units{
      {"1/cm", {decimal("29979245800"), 0}}, {"MHz", {1'000'000, 0}}, {"GHz", {1'000'000'000, 0}}};
  return units;
}

const std::vector<unit>& angular_velocity_units() {
  static const std::vector<unit> units = [] {
    std::vector<unit> result;
    for (const unit& angle : angle_units()) {
      for (const unit& time : time_units()) {
        result.push_back({angle.name + '/' + time.name, angle.size / time.size});
      }
    }
    result.push_back({"rpm", {rational(1, 30), 1}});
    result.push_back({"Hz", {2, 1}});
    return result;
  }();
  return units;
}

pi_scale inertia_times_rotational_constant() { return {decimal("6.62607015e-34") / 8, -2}; }

}  // namespace polhode
