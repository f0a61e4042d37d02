# Writes FILE with the revision of SOURCE, with a + where files were changed since; only if that is news.
cmake_policy(VERSION 3.25)
execute_process(COMMAND git -C ${SOURCE} describe --always --dirty=+ --exclude=* OUTPUT_VARIABLE revision ERROR_QUIET
                OUTPUT_STRIP_TRAILING_WHITESPACE)
if(NOT revision)
  set(revision unknown)  # No git, or an unpacked archive.
endif()
file(CONFIGURE OUTPUT ${FILE} CONTENT "#define HEFT_REVISION \"@revision@\"\n" @ONLY)
