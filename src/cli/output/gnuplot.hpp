#pragma once

#include <string>

namespace polhode::cli {

/// What gnuplot writes to its standard output for this program. Throws output_error where it is not
/// installed or fails, which says how to do without it.
[[nodiscard]] std::string run_gnuplot(const std::string& program,
                                      const std::string& way_without = "give --format csv");

/// Throws output_error where gnuplot does not start or cannot write both kinds of picture.
void require_gnuplot(const std::string& way_without);

/// As require_gnuplot, and throws output_error where it was built without pdfcairo, which draws
/// PDF.
void require_pdf(const std::string& way_without);

}  // namespace polhode::cli
