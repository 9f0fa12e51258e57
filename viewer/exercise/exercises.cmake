# The texts of the exercises as a source, so that an installed program has them. Made anew when one changes.
set(lessons_folder ${PROJECT_SOURCE_DIR}/lessons)
file(GLOB_RECURSE exercise_files CONFIGURE_DEPENDS RELATIVE ${lessons_folder}
     ${lessons_folder}/exercise/*.h ${lessons_folder}/*/exercises/*/*)
list(FILTER exercise_files INCLUDE REGEX "^exercise/|^[^/]+/exercises/[^/]+/")
list(APPEND exercise_files exercises.txt)
list(SORT exercise_files)
list(TRANSFORM exercise_files PREPEND ${lessons_folder}/ OUTPUT_VARIABLE exercise_paths)
set(exercise_list ${CMAKE_CURRENT_BINARY_DIR}/exercise_files.txt)
list(JOIN exercise_files "\n" exercise_lines)
file(CONFIGURE OUTPUT ${exercise_list} CONTENT "${exercise_lines}\n" @ONLY)
set(exercise_texts ${CMAKE_CURRENT_BINARY_DIR}/exercise_texts.cpp)
add_custom_command(
  OUTPUT ${exercise_texts}
  COMMAND ${CMAKE_COMMAND} -DLIST=${exercise_list} -DFOLDER=${lessons_folder} -DOUTPUT=${exercise_texts}
          -P ${CMAKE_CURRENT_SOURCE_DIR}/exercise/embed.cmake
  DEPENDS ${exercise_paths} ${exercise_list} ${CMAKE_CURRENT_SOURCE_DIR}/exercise/embed.cmake
  COMMENT "Embedding the exercises")
