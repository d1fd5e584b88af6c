# Writes OUTPUT, a C++ source with the templates in SOURCE_DIR as constants.
set(text "// Written by templates.cmake from the files it names.\n#include \"view/templates.hpp\"\n\nnamespace twiddle::view\n{\n")
foreach(page replay index)
  file(READ ${SOURCE_DIR}/${page}.html html)
  string(APPEND text "\nconst char *const ${page}_template = R\"page(${html})page\";\n")
endforeach()
file(WRITE ${OUTPUT} "${text}\n} // namespace twiddle::view\n")
