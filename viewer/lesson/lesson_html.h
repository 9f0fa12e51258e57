#pragma once

#include <string>

#include "lesson/course.h"

namespace hsr {

/// The name of a lesson's page.
std::string page_name(const Lesson& lesson);

/// The name of the page of a source, a path from the root of the kit.
std::string source_page_name(std::string_view path);

/// The lesson's text as HTML, to stand in a page's body. The heading number k of the text, from 0, has the id
/// "hk".
std::string lesson_html(const OpenLesson& lesson);

}  // namespace hsr
