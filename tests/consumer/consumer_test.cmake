# Installs Heft into a scratch folder, checks what the system gets to see, builds the consumer against it, and lets it weigh
# a recording that the installed heft made. Variables: RUN, SOURCE, BUILD, CONFIG, COMPILER, WORK.
if(NOT RUN)
  message("EVERY TEST SKIPPED: configure with -DHEFT_CONSUMER_TEST=ON to build a program against an installed Heft")
  return()
endif()

function(run)
  execute_process(COMMAND ${ARGN} OUTPUT_VARIABLE out ERROR_VARIABLE err RESULT_VARIABLE code)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "${ARGN}\nended with ${code}\n${out}${err}")
  endif()
  set(out "${out}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK})
run(${CMAKE_COMMAND} --install ${BUILD} --config ${CONFIG} --prefix ${WORK}/installed)
# Moved away from where it was installed: nothing may depend on the place.
file(RENAME ${WORK}/installed ${WORK}/moved)
run(${CMAKE_COMMAND} -S ${SOURCE}/tests/consumer -B ${WORK}/build -DCMAKE_BUILD_TYPE=${CONFIG} -DCMAKE_CXX_COMPILER=${COMPILER}
    -DCMAKE_PREFIX_PATH=${WORK}/moved)
run(${CMAKE_COMMAND} --build ${WORK}/build --config ${CONFIG})
run(${WORK}/moved/bin/heft simulate --motion excitation --seed 1 -o ${WORK}/rec.csv)
find_program(consumer consumer PATHS ${WORK}/build ${WORK}/build/${CONFIG} NO_DEFAULT_PATH REQUIRED)
run(${consumer} ${WORK}/rec.csv)
# The built-in tool weighs 0.8 kg.
string(REGEX MATCHALL "[0-9.]+" masses "${out}")
list(LENGTH masses count)
foreach(mass IN LISTS masses)
  if(NOT count EQUAL 2 OR mass LESS 0.79 OR mass GREATER 0.81)
    message(FATAL_ERROR "The consumer weighs ${out} kg instead of 0.8 kg, twice")
  endif()
endforeach()
# What is loaded at its first use is found: FCL keeps the suggested motion off a box, and Ceres fits.
file(WRITE ${WORK}/room.json [[{"schema": "heft.room/1", "obstacles": [{"name": "post", "box": {"size_m": [0.2, 0.2, 1], "xyz_m": [1.5, 0, 0.5]}}]}]])
run(${WORK}/moved/bin/heft coach ${WORK}/rec.csv --shape box:0.06,0.06,0.16 --room ${WORK}/room.json)
run(${WORK}/moved/bin/heft estimate ${WORK}/rec.csv --method ceres --json -)
if(NOT out MATCHES "\"usable\": *true")
  message(FATAL_ERROR "Ceres is not found: ${out}")
endif()
