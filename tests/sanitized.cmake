# Tests where a sanitizer looks on (FROND_SANITIZE), or lines are counted (FROND_COVERAGE). They may know the former, by
# SANITIZED and SANITIZED_THREAD; every folder that has tests calls frond_sanitized() last, which gives them patience and
# options.
if(FROND_SANITIZE)
    add_compile_definitions(SANITIZED)
endif()
if(FROND_SANITIZE MATCHES thread)
    add_compile_definitions(SANITIZED_THREAD)
endif()

function(frond_sanitized)
    if(NOT FROND_SANITIZE AND NOT FROND_COVERAGE)
        return()
    endif()
    set(patience 4)
    if(FROND_SANITIZE MATCHES thread OR FROND_COVERAGE)
        set(patience 12)
    endif()
    get_property(tests DIRECTORY PROPERTY TESTS)
    foreach(test IN LISTS tests)
        get_test_property(${test} TIMEOUT limit)
        math(EXPR limit "${patience} * ${limit}")
        set_tests_properties(${test} PROPERTIES TIMEOUT ${limit})
        # Libraries that were not built so: umockdev's comes before the sanitizer's, Mesa, D-Bus and fontconfig keep what they
        # have until the end, and all of them wait in ways that only they know.
        set_property(TEST ${test} APPEND PROPERTY ENVIRONMENT
            FROND_PATIENCE=${patience} # for scripts; programs have tests/unit/cases/patience.h
            ASAN_OPTIONS=detect_stack_use_after_return=1:strict_string_checks=1:verify_asan_link_order=0
            UBSAN_OPTIONS=print_stacktrace=1
            LSAN_OPTIONS=suppressions=${CMAKE_SOURCE_DIR}/tests/leaks.supp:print_suppressions=0
            TSAN_OPTIONS=halt_on_error=1:second_deadlock_stack=1:ignore_noninstrumented_modules=1)
    endforeach()
endfunction()
