# Writes OUTPUT, a C++ source with the pages and their script in SOURCE_DIR as constants.
set(text "// Written by templates.cmake from the files it names.\n#include \"view/templates.hpp\"\n")
string(APPEND text "\nnamespace twiddle::view\n{\n")
foreach(part replay.html index.html scene.js replay.js)
  file(READ ${SOURCE_DIR}/${part} content)
  string(REPLACE . _ name ${part})
  string(APPEND text "\nconst char *const ${name} = R\"part(${content})part\";\n")
endforeach()
file(WRITE ${OUTPUT} "${text}\n} // namespace twiddle::view\n")
