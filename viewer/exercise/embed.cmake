# Writes OUTPUT, a source that holds the text files listed in LIST (one path a line, relative to FOLDER), so that
# the program has the exercises wherever it is installed.
file(STRINGS ${LIST} paths)
set(source "#include \"exercise/texts.h\"\n\nnamespace hsr {\n\nconst std::map<std::string, std::string_view, std::less<>>& embedded_texts() {\n  static const std::map<std::string, std::string_view, std::less<>> texts = {\n")
foreach(path IN LISTS paths)
  file(READ ${FOLDER}/${path} text)
  string(APPEND source "{\"${path}\", R\"hsr_text(${text})hsr_text\"},\n")
endforeach()
string(APPEND source "  };\n  return texts;\n}\n\n}  // namespace hsr\n")
file(WRITE ${OUTPUT} "${source}")
