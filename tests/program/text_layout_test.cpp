#include "text_layout.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

using Lines = std::vector<std::string>;

TEST_CASE("program: words are wrapped at spaces, and line breaks stay") {
  CHECK(hsr::wrap("", 10) == Lines{""});
  CHECK(hsr::wrap("one two three", 7) == Lines{"one two", "three"});
  CHECK(hsr::wrap("one two three", 6) == Lines{"one", "two", "three"});
  CHECK(hsr::wrap("incomprehensible word", 4) == Lines{"incomprehensible", "word"});
  CHECK(hsr::wrap("a\n\nb", 10) == Lines{"a", "", "b"});
  CHECK(hsr::wrap("n² ≥ 4", 6) == Lines{"n² ≥ 4"});  // six characters in nine bytes
}

TEST_CASE("program: a definition's text stands in its column") {
  CHECK(hsr::definition("name", "what it is", 2, 10) == "  name    what it is\n");
  CHECK(hsr::definition("long name", "what it is", 2, 10) == "  long name\n          what it is\n");
  const std::string text = hsr::definition("x", std::string(50, 'a').append(1, ' ').append(50, 'b'), 0, 4);
  CHECK(text == "x   " + std::string(50, 'a') + "\n    " + std::string(50, 'b') + "\n");
}

TEST_CASE("program: numbers are written for people") {
  CHECK(hsr::grouped(0) == "0");
  CHECK(hsr::grouped(999) == "999");
  CHECK(hsr::grouped(1000) == "1,000");
  CHECK(hsr::grouped(1234567) == "1,234,567");
  CHECK(hsr::counted(1, "triangle") == "1 triangle");
  CHECK(hsr::counted(69312, "triangle") == "69,312 triangles");
  CHECK(hsr::three_digits(0.0) == "0.00");
  CHECK(hsr::three_digits(9.994) == "9.99");
  CHECK(hsr::three_digits(9.996) == "10.0");
  CHECK(hsr::three_digits(99.94) == "99.9");
  CHECK(hsr::three_digits(99.96) == "100");
  CHECK(hsr::three_digits(12345.6) == "12,346");
  CHECK(hsr::milliseconds(1.5) == "1.50 ms");
}

TEST_CASE("program: a table aligns its columns and titles groups of them") {
  hsr::TextTable table({"name", "a", "b", "c"});
  table.group_columns({{"pixels", 1, 2}});
  table.add_row({"x", "1", "22", "333"});
  table.add_row({"longer", "10,000", "2", "3"});
  CHECK(table.text() ==
        "        - pixels -\n"
        "name         a   b    c\n"
        "x            1  22  333\n"
        "longer  10,000   2    3\n");
}

TEST_CASE("program: a name too long for the page has a line of its own") {
  hsr::TextTable table({"name", "value"});
  table.add_row({std::string(120, 'n'), "1"});
  table.add_row({"x", "2"});
  CHECK(table.text() == "name" + std::string(89, ' ') + "  value\n" + std::string(120, 'n') + "\n" +
                            std::string(98, ' ') + " 1\n" + "x" + std::string(97, ' ') + " 2\n");
}
