# cmake -DOUT=FILE.c -DSOURCES=a.comp;b.glsl -P embed.cmake: shader sources as C strings, a line a line, so that a debugger and a
# diff can read them.
set(text "/* Made by shaders/base/embed.cmake. */\n#include \"program.h\"\n\nconst struct shader_source shader_sources[] = {\n")
foreach(source IN LISTS SOURCES)
    get_filename_component(name ${source} NAME)
    file(READ ${source} body)
    string(REPLACE "\\" "\\\\" body "${body}")
    string(REPLACE "\"" "\\\"" body "${body}")
    string(REPLACE "\n" "\\n\"\n     \"" body "${body}")
    string(APPEND text "    {\"${name}\",\n     \"${body}\"},\n")
endforeach()
string(APPEND text "    {0, 0},\n};\n")
file(WRITE ${OUT} "${text}")
