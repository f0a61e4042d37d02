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
if(out LESS 0.79 OR out GREATER 0.81)
  message(FATAL_ERROR "The consumer weighs ${out} kg instead of 0.8 kg")
endif()
