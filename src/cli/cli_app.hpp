#pragma once

// CLI11's reader of command lines, for headers that only hand it on. <CLI/CLI.hpp> costs seconds in each source that
// includes it: those include it that declare options.

namespace CLI {
class App;
}  // namespace CLI
