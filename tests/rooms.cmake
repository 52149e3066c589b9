# What a room may include. `frond_room(NAME)` makes the build of NAME depend on a scan of its sources: a header the room must
# not know stops the build with file and line. Project headers are told apart by include paths: a room sees only what it links.
set(FROND_SIM_HEADERS "assert|float|limits|math|pthread|stdalign|stdatomic|stdbool|stddef|stdint|stdlib|string|immintrin|arm_neon|sys/mman|unistd")

function(frond_room name)
    set(stamp ${CMAKE_CURRENT_BINARY_DIR}/${name}.room)
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.[ch] ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
    add_custom_command(OUTPUT ${stamp}
        COMMAND ${CMAKE_COMMAND} -DROOM=${name} -DFOLDER=${CMAKE_CURRENT_SOURCE_DIR} -DSTAMP=${stamp}
            "-DSIM_HEADERS=${FROND_SIM_HEADERS}" -P ${CMAKE_SOURCE_DIR}/tests/check_room.cmake
        DEPENDS ${sources} ${CMAKE_SOURCE_DIR}/tests/check_room.cmake
        COMMENT "Checking what ${name}/ includes" VERBATIM)
    add_custom_target(room_${name} ALL DEPENDS ${stamp})
    add_dependencies(frond_${name} room_${name})
endfunction()
