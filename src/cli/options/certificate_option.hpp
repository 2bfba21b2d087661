#pragma once

// --certificate FILE: what was computed, with what `polhode check` needs to show it again.

#include "file_option.hpp"
#include "polhode/certificate/certificate.hpp"

namespace polhode::cli {

class certificate_option : public file_option {
 public:
  certificate_option() : file_option("--certificate", "Write a certificate for `polhode check`") {}

  void write(const json& certificate) { file_option::write(certificate.dump(2) + '\n'); }
  /// Throws not_certified_error with --certificate: there is nothing to certify.
  void expect_certified(bool certified) const;
};

}  // namespace polhode::cli
