#include "examination.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include "body.hpp"
#include "digest.hpp"
#include "polynomial.hpp"
#include "statements/shared.hpp"

namespace polhode::checker {
namespace {

constexpr long most_digits_of_number = 100'000;
constexpr long most_input_bits = 20'000;
/// Behind the point, of a number's ends.
constexpr long most_working_bits = 1'200'000;
/// Bits for questions that are not about a number's digits.
constexpr std::array<long, 5> precisions{128, 256, 512, 2048, 8192};

/// mantissa * 2^exponent with an odd mantissa, or 0 * 2^0.
rational dyadic(const place& where) {
  constexpr long most_exponent = 4'000'000;
  where.expect_keys({"mantissa", "exponent"});
  const integer mantissa = where["mantissa"].big();
  const long exponent = where["exponent"].whole(-(1L << 40U), 1L << 40U);
  if (std::abs(exponent) > most_exponent) {
    where["exponent"].not_checkable("it is beyond " + std::to_string(most_exponent) + " in size");
  }
  if (mantissa == 0 ? exponent != 0 : mantissa % 2 == 0) {
    where["mantissa"].malformed("it is even; mantissa and exponent must be in lowest form");
  }
  const budget::at here = where.working();
  where.work().rationals(1, bit_length(mantissa) + std::abs(exponent));
  return rational(mantissa) * power_of_two(exponent);
}

/// That `value` is the digits that both ends share.
void expect_shared(const place& where, const range& exact, long digits) {
  const budget::at here = where.working();
  const std::string low = decimal(exact.lower, digits, rounding::to_zero, where.work());
  if (low != decimal(exact.upper, digits, rounding::to_zero, where.work())) {
    where.not_checkable("the exact ends do not share " + std::to_string(digits) + " digits");
  }
  where.expect_text(low);
}

/// The fraction as it is written, where it is not too long to read.
std::string in_short(const place& where, const rational& value) {
  constexpr std::size_t longest = 100;
  if (where.text().size() <= longest) return where.text();
  return decimal_for_reading(value, 30, where.work()) + " (a fraction of " +
         std::to_string(where.text().size()) + " characters)";
}

void expect_range(const place& where, const rational& value, bool right, const char* name) {
  if (!right) {
    where.malformed("it is " + in_quotes(where.text()) + "; it must be " + name);
  }
  if (bit_length(value) > most_input_bits) where.not_checkable("it has too many digits");
}

}  // namespace

long bits_for_digits(long digits) {
  return static_cast<long>(static_cast<double>(digits) * 3.3219281) + 2;
}

void expect_outward(const place& where, const rational& end, long digits, rounding way) {
  const rational given = where.decimal_value();
  const budget::at here = where.working();
  const bool down = way == rounding::down;
  if (down ? given > end : given < end) {
    where.refute("it is " + in_quotes(where.text()) + ", which excludes the exact " +
                 (down ? "lower" : "upper") + " end");
  }
  // The decimal that is nearest, outward, is less than a unit away; two are allowed for how it was
  // found.
  const std::string nearest = decimal(end, digits, way, where.work());
  where.work().rationals(4, bit_length(given) + bit_length(end) + 4 * digits);
  rational value;
  static_cast<void>(read_decimal(nearest, value));
  const rational size = end < 0 ? rational(-end) : end;
  const rational unit(size * power_of_ten(1 - digits));
  if (abs(rational(given - value)) > unit) {
    where.refute("it is " + in_quotes(where.text()) + "; it must be " + in_quotes(nearest) +
                 ", the exact end rounded outward");
  }
}

range expect_inside(const place& where, const range& r, long bits,
                    const std::function<interval(precision bits)>& f) {
  const budget::at here = where.working();
  for (int attempt = 0; attempt < 5; ++attempt, bits += bits / 2 + 64) {
    try {
      const interval x = f(precision(bits, where.work()));
      if (is_inside(x, r.lower, r.upper)) return {x.lower(), x.upper()};
      if (!overlaps(x, r.lower, r.upper)) {
        where.refute("the true value is between " +
                     decimal(x.lower(), 25, rounding::down, where.work()) + " and " +
                     decimal(x.upper(), 25, rounding::up, where.work()) + ", outside it");
      }
    } catch (const undecided&) {  // more bits
    }
  }
  where.not_checkable("the checker did not find the true value closely enough");
}

void expect_near(const place& number, const range& exact, long digits) {
  const rational lower = number["lower"].decimal_value();
  const rational upper = number["upper"].decimal_value();
  const budget::at here = number.working();
  number.work().rationals(
      6, bit_length(exact.lower) + bit_length(exact.upper) + bit_length(lower) + bit_length(upper));
  // The prover writes three digits more than it was asked for, rounded outward.
  const rational size = std::max(abs(exact.lower), abs(exact.upper));
  const rational width(exact.upper - exact.lower + size * power_of_ten(-digits - 2));
  if (lower > exact.lower) number["lower"].refute("it excludes the exact lower end");
  if (upper < exact.upper) number["upper"].refute("it excludes the exact upper end");
  if (lower < exact.lower - width) number["lower"].refute("it is far below the exact lower end");
  if (upper > exact.upper + width) number["upper"].refute("it is far above the exact upper end");
}

void expect_radius(const place& where) {
  const rational value = where["value"].decimal_value();
  const rational radius = where["radius"].decimal_value();
  const rational lower = where["lower"].decimal_value();
  const rational upper = where["upper"].decimal_value();
  const budget::at here = where.working();
  where.work().rationals(
      6, bit_length(value) + bit_length(radius) + bit_length(lower) + bit_length(upper));
  const rational below(value - lower);
  const rational above(upper - value);
  const rational least = below > above ? below : above;
  if (radius < least) {
    where["radius"].refute("value - radius is above lower, or value + radius below upper");
  }
  if (radius > 2 * least) where["radius"].refute("it is more than twice what it must be");
}

void expect_rounded_digits(const place& where, long digits) {
  const rational value = where["value"].decimal_value();
  const rational radius = where["radius"].decimal_value();
  const budget::at here = where.working();
  where.work().rationals(4, bit_length(value) + bit_length(radius) + 4 * digits);
  // The unit of the n-th digit is above |value|/10^n.
  const rational size = value < 0 ? rational(-value) : value;
  if (digits > 0 && radius >= size * power_of_ten(1 - digits)) {
    where["digits"].refute("the radius is more than one unit of the last of so many digits");
  }
}

std::string in_between(const std::string& it, const range& r, long digits, budget& work) {
  constexpr long most_shown = 40;
  const long shown = std::min(digits, most_shown) + 3;
  return it + " is between " + decimal(r.lower, shown, rounding::down, work) + " and " +
         decimal(r.upper, shown, rounding::up, work) +
         (digits > most_shown ? " (here cut short: " + std::to_string(digits) + " digits)" : "");
}

void expect_software(const place& software) {
  software.expect_keys({"polhode", "mpfr", "gmp", "boost"});
  for (const char* name : {"polhode", "mpfr", "gmp", "boost"}) {
    constexpr std::size_t longest = 100;
    if (software[name].text().size() > longest) software[name].malformed("it is too long");
  }
}

void expect_grounds(const place& certificate, std::string_view tier,
                    const std::vector<stated_text>& argument) {
  certificate["tier"].expect_text(tier);
  const place stated = certificate["argument"];
  for (std::size_t i = 0; i < argument.size(); ++i) {
    const place one = stated.at(i);
    one.expect_keys({"kind", "statement"});
    one["kind"].expect_text(argument[i].kind);
    one["statement"].expect_text(argument[i].statement);
  }
  if (stated.size() > argument.size()) {
    stated.at(argument.size()).malformed("this claim has no such argument");
  }
  // The kinds of its steps, in this order.
  std::vector<std::string_view> kinds;
  const place facts = certificate["facts"];
  for (const std::string_view kind :
       {std::string_view(decided_exactly), std::string_view(enclosed), statements::proved_in_coq,
        statements::argued_in_words, statements::only_cited}) {
    bool has_it = kind == enclosed && !certificate["numbers"].value().empty();
    for (std::size_t i = 0; i < facts.size(); ++i) {
      has_it = has_it || facts.at(i)["kind"].text() == kind;
    }
    for (const stated_text& s : argument) has_it = has_it || s.kind == kind;
    if (has_it) kinds.push_back(kind);
  }
  const place given = certificate["rests_on"];
  for (std::size_t i = 0; i < kinds.size(); ++i) given.at(i).expect_text(kinds[i]);
  if (given.size() > kinds.size()) {
    given.at(kinds.size()).refute("it rests on nothing of that kind");
  }
}

std::vector<std::string> grounds_of(const place& certificate) {
  const place kinds = certificate["rests_on"];
  std::vector<std::string> result;
  for (std::size_t i = 0; i < kinds.size(); ++i) result.push_back(kinds.at(i).text());
  return result;
}

void examination::expect_words() {
  root_["statement"].expect_text(text_.statement);
  root_["formula"].expect_text(text_.formula);
  root_["reference"].expect_text(text_.reference);
  expect_software(root_["software"]);
  report_.subject = "claim " + in_quotes(text_.name);
  report_.statement = {std::string(text_.statement), std::string(text_.formula)};
}

// ---------------------------------------------------------------------------------------------
// Inputs

void examination::read_no_inputs() { root_["inputs"].expect_keys({}); }

void examination::read_body() {
  const place inputs = root_["inputs"];
  if (inputs.has("xx")) {
    inputs.expect_keys({"xx", "yy", "zz", "xy", "xz", "yz"});
    read_tensor();
  } else {
    inputs.expect_keys({"a", "b"});
    read_a_and_b();
  }
}

void examination::read_a_and_b() {
  const place inputs = root_["inputs"];
  const rational a = inputs["a"].fraction();
  const rational b = inputs["b"].fraction();
  expect_range(inputs["a"], a, a > 0, "positive");
  expect_range(inputs["b"], b, b > 0 && b < 1, "between 0 and 1, ends excluded");
  work().rationals(8, bit_length(a) + bit_length(b));
  body_ = {a, b};
  report_.subject += " for the " + body_.kind_in_words() + " body a = " + in_short(inputs["a"], a) +
                     ", b = " + in_short(inputs["b"], b);
}

void examination::read_tensor() {
  constexpr long digits = 12;
  const place inputs = root_["inputs"];
  const budget::at here = inputs.working();
  std::array<rational, 6> entries;
  std::string given;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const char* name = statements::entries_of_tensor[i];
    entries[i] = inputs[name].fraction();
    expect_range(inputs[name], entries[i], true, "a number");
    given += std::string(i == 0 ? "" : ", ") + name + " = " + in_short(inputs[name], entries[i]);
  }
  std::shared_ptr<const tensor> whole;
  try {
    whole = std::make_shared<const tensor>(entries, work());
  } catch (const std::invalid_argument& problem) {
    inputs.malformed(std::string("it must be a body with three different moments: ") +
                     problem.what());
  }
  body_ = {whole->a(), whole->b(), whole};
  report_.subject += " for the " + body_.kind_in_words() +
                     " body a = " + decimal_for_reading(body_.a, digits, work()) +
                     ", b = " + decimal_for_reading(body_.b, digits, work()) +
                     " with the inertia tensor " + given;
}

void examination::read_motion() {
  const place inputs = root_["inputs"];
  if (inputs.has("xx")) {
    inputs.expect_keys({"xx", "yy", "zz", "xy", "xz", "yz", "u"});
    read_tensor();
  } else {
    inputs.expect_keys({"a", "b", "u"});
    read_a_and_b();
  }
  u_ = inputs["u"].fraction();
  expect_range(inputs["u"], u_, u_ > 0 && u_ <= 1, "above 0 and at most 1");
  report_.subject += ", u = " + in_short(inputs["u"], u_);
}

long examination::input_bits() const {
  return 2 * (bit_length(body_.a) + bit_length(body_.b) + bit_length(u_));
}

// ---------------------------------------------------------------------------------------------
// Facts

place examination::fact(const std::string& statement, const char* kind) {
  const place one = root_["facts"].at(facts_++);
  one.expect_keys({"statement", "holds", "kind"});
  one["statement"].expect_text(statement);
  one["holds"].expect_true();
  one["kind"].expect_text(kind);
  report_.checks.push_back(statement);
  if (statement.starts_with("at the given")) report_.statement.push_back(statement);
  return one["statement"];
}

void examination::fact(const std::string& statement, bool shown, const char* kind) {
  const place where = fact(statement, kind);
  if (!shown) where.refute("it is not so");
}

void examination::fact(const std::string& statement,
                       const std::function<std::optional<bool>(precision bits)>& shown) {
  const place where = fact(statement, enclosed);
  const budget::at here = where.working();
  for (const long bits : precisions) {
    try {
      const std::optional<bool> answer = shown(precision(bits + input_bits(), work()));
      if (answer && !*answer) where.refute("it is not so");
      if (answer) return;
    } catch (const undecided&) {  // more bits
    }
  }
  where.not_checkable("the checker's precision does not decide it");
}

bool examination::is_missing(const std::string& what) {
  const std::string note = statements::fill(statements::missing_witness, {what});
  if (root_["method"].text().find(note) == std::string::npos) return false;
  notes_ += note;
  report_.left_out.push_back(what);
  return true;
}

void examination::steps() {
  if (text_.steps.empty()) return;
  const place all = witness("polynomials");
  for (std::size_t i = 0; i < text_.steps.size(); ++i) {
    constexpr long units_of_a_step = 200'000;  // of the checker's own polynomials
    const statements::polynomial_step& step = text_.steps[i];
    const place one = all.at(i);
    const budget::at here = one.working();
    work().spend(units_of_a_step);
    const polynomial left = polynomial::read(step.left);
    const polynomial right = polynomial::read(step.right);
    bool holds = false;
    one["kind"].expect_text(statements::form_in_words(step));
    one["left"].expect_text(step.left);
    one["right"].expect_text(step.right);
    if (step.form == statements::step_form::slope) {
      one.expect_keys({"kind", "left", "over", "variable", "right"});
      one["over"].expect_text(step.over);
      one["variable"].expect_text(step.variable);
      const polynomial over = polynomial::read(step.over);
      const char x = step.variable.front();
      holds = left.derivative(x) * over - left * over.derivative(x) == right;
    } else if (step.form == statements::step_form::identity) {
      one.expect_keys({"kind", "left", "right"});
      holds = right == left;
    } else {
      const bool strict = step.form == statements::step_form::positive;
      one.expect_keys({"kind", "left", "right", "letters", "conclusion"});
      one["letters"].expect_text(step.letters);
      one["conclusion"].expect_text(statements::conclusion_of(step));
      const letter_ranges letters(step.letters);
      holds = letters.put_into(right) == left && letters.show_sign(right, strict);
    }
    fact(statements::sentence_of(step), holds);
  }
  if (all.size() > text_.steps.size()) {
    all.at(text_.steps.size()).malformed("this claim has no such step");
  }
}

// ---------------------------------------------------------------------------------------------
// Numbers

examination::ends examination::next_number(const std::string& name) {
  const place numbers = root_["numbers"];
  const place where = numbers[name];
  if (std::next(numbers.value().begin(), static_cast<std::ptrdiff_t>(numbers_)).key() != name) {
    where.malformed("it is not in its place: it must be number " + std::to_string(numbers_ + 1));
  }
  ++numbers_;
  const bool rounded = where.has("rounded");
  if (rounded) {
    where.expect_keys(
        {"value", "radius", "lower", "upper", "digits", "rounded", "digits_asked", "dyadic"});
    where["rounded"].expect_true();
  } else {
    where.expect_keys({"value", "radius", "lower", "upper", "digits", "digits_asked", "dyadic"});
  }
  const long digits = where["digits"].whole(1, 1L << 40U);
  if (digits > most_digits_of_number) {
    where["digits"].not_checkable("it has more than " + std::to_string(most_digits_of_number) +
                                  " digits");
  }
  where["digits_asked"].expect_whole(digits);
  if (digits_ != 0) where["digits"].expect_whole(digits_);
  digits_ = digits;
  const range exact = dyadic_range(where["dyadic"]);
  const rational width(exact.upper - exact.lower);
  if (rounded) {
    expect_rounded_digits(where, digits);
    expect_near(where, exact, digits);
  } else {
    expect_shared(where["value"], exact, digits);
    expect_outward(where["lower"], exact.lower, digits + 3, rounding::down);
    expect_outward(where["upper"], exact.upper, digits + 3, rounding::up);
  }
  expect_radius(where);
  const long bits = bit_length(integer(denominator(width))) + 16;
  const long leading_zeros = std::max(0L, bit_length(integer(denominator(exact.lower))) -
                                              bit_length(integer(numerator(exact.lower))));
  if (bits > most_working_bits ||
      bits - leading_zeros > 40 * bits_for_digits(digits) + 16 * input_bits() + 8192) {
    where["dyadic"].not_checkable("its ends are nearer to each other than its digits need");
  }
  report_.checks.push_back(name + " = " +
                           decimal_for_reading(exact.lower, std::min(digits, 20L), work()) +
                           (digits > 20 ? " to " + std::to_string(digits) + " digits" : ""));
  report_.statement.push_back(in_between(name, exact, digits, work()));
  return {where, exact, bits};
}

range examination::number(const std::string& name,
                          const std::function<interval(precision bits)>& f) {
  const ends e = next_number(name);
  expect_inside(e.where["dyadic"], e.exact, e.bits + input_bits(), f);
  return e.exact;
}

range examination::root_number(
    const std::string& name, bool decreases,
    const std::function<interval(const rational& x, precision bits)>& f) {
  const ends e = next_number(name);
  const auto check_end = [&](const char* end, const rational& x, bool positive) {
    const place where = e.where["dyadic"][end];
    const budget::at here = where.working();
    for (long bits = e.bits + 32 + input_bits(), attempt = 0; attempt < 5;
         ++attempt, bits += bits / 2 + 64) {
      try {
        const interval value = f(x, precision(bits, work()));
        if (positive ? value.is_positive() : value.is_negative()) return;
        if (positive ? value.is_negative() : value.is_positive()) {
          where.refute("the root is not on this side of it");
        }
      } catch (const undecided&) {  // more bits
      }
    }
    where.not_checkable("the checker's precision does not decide on which side of it the root is");
  };
  check_end("lower", e.exact.lower, decreases);
  check_end("upper", e.exact.upper, !decreases);
  return e.exact;
}

// ---------------------------------------------------------------------------------------------
// Witness

place examination::witness(const std::string& key) {
  witness_keys_.push_back(key);
  return root_["witness"][key];
}

range examination::bracket(const place& where) {
  where.expect_keys({"lower", "upper"});
  range r{where["lower"].fraction(), where["upper"].fraction()};
  if (bit_length(r.lower) > most_input_bits || bit_length(r.upper) > most_input_bits) {
    where.not_checkable("its ends have too many digits");
  }
  if (r.lower >= r.upper) where.refute("its lower end is not below its upper end");
  return r;
}

range examination::dyadic_range(const place& where) {
  where.expect_keys({"lower", "upper"});
  range r{dyadic(where["lower"]), dyadic(where["upper"])};
  if (r.lower >= r.upper) where.refute("its lower end is not below its upper end");
  return r;
}

range examination::decimals(const place& where, const std::function<interval(precision bits)>& f) {
  const bool rounded = where.has("rounded");
  if (rounded) {
    where.expect_keys({"value", "radius", "lower", "upper", "digits", "rounded"});
    where["rounded"].expect_true();
  } else {
    where.expect_keys({"value", "radius", "lower", "upper", "digits"});
  }
  const long digits = where["digits"].whole(rounded ? 0 : 1, 1L << 40U);
  if (digits > most_digits_of_number) where["digits"].not_checkable("it has too many digits");
  range r{where["lower"].decimal_value(), where["upper"].decimal_value()};
  if (r.lower >= r.upper) where.refute("its lower end is not below its upper end");
  expect_radius(where);
  if (rounded) expect_rounded_digits(where, digits);
  const range own = expect_inside(where, r, bits_for_digits(digits) + 64, f);
  if (!rounded) expect_shared(where["value"], own, digits);
  return r;
}

// ---------------------------------------------------------------------------------------------
// The end

void examination::finish() {
  root_["method"].expect_text(std::string(text_.method) + notes_);
  expect_grounds(root_, text_.tier, text_.argument);
  report_.grounds = grounds_of(root_);
  report_.tier = text_.tier;
  const place facts = root_["facts"];
  if (facts.size() > facts_) facts.at(facts_).malformed("this claim has no such fact");
  const place numbers = root_["numbers"];
  if (numbers.value().size() > numbers_) {
    const auto extra =
        std::next(numbers.value().begin(), static_cast<std::ptrdiff_t>(numbers_)).key();
    numbers[extra].malformed("this claim has no such number");
  }
  const place given = root_["witness"];
  for (const auto& [key, value] : given.value().items()) {
    if (std::find(witness_keys_.begin(), witness_keys_.end(), key) == witness_keys_.end()) {
      given[key].malformed("a certificate of this claim has no such witness");
    }
  }
  root_["digest"].expect_text(digest_of(root_));
}

std::string multiple_of_pi(const rational& q) {
  const integer n = numerator(q);
  const integer d = denominator(q);
  std::string text = n == 1 ? "pi" : n.str().append(" pi");
  if (d != 1) text.append("/").append(d.str());
  return text;
}

std::string in_decimals(const range& r, budget& work) {
  constexpr long digits = 13;
  return decimal(r.lower, digits, rounding::down, work) + " and " +
         decimal(r.upper, digits, rounding::up, work);
}

}  // namespace polhode::checker
