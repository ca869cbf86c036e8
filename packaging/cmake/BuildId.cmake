# Writes a source file with the identity of a build of core: a hash of all its sources, the compiler and the flags that
# change results. Called at build time, whenever a source of core changed:
#   cmake -DSOURCE_DIR=.. -DCOMPILER=.. -DFLAGS=.. -DOUTPUT=.. -P BuildId.cmake
file(GLOB_RECURSE sources LIST_DIRECTORIES false ${SOURCE_DIR}/core/*.h ${SOURCE_DIR}/core/*.cpp)
list(SORT sources)
set(all "${COMPILER} ${FLAGS}")
foreach(source IN LISTS sources)
  file(SHA256 ${source} hash)
  file(RELATIVE_PATH name ${SOURCE_DIR} ${source})
  string(APPEND all "${name} ${hash}\n")
endforeach()
string(SHA256 id "${all}")
string(SUBSTRING ${id} 0 16 id)
file(WRITE ${OUTPUT}.new "#include \"core/exercise/BuildId.h\"\n\nnamespace sagara::core {\nstd::string_view coreBuildId() { return \"${id}\"; }\n}  // namespace sagara::core\n")
file(COPY_FILE ${OUTPUT}.new ${OUTPUT} ONLY_IF_DIFFERENT)
