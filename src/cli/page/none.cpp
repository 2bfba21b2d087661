// In the place of the page's template where there is no npm to bundle it.

#include "scene_page_template.hpp"

namespace polhode::cli {

const std::string_view page_template;

}  // namespace polhode::cli
