#include <fstream>
#include <iostream>
#include <iterator>
#include <polhode/checker/check.hpp>
#include <string>

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  std::ifstream file(argv[1]);
  const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  const polhode::checker::report r = polhode::checker::check(text);
  std::cout << polhode::checker::to_text(r.result) << ": " << r.subject << '\n';
}
