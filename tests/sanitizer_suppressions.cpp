// Read by the sanitizers alone. Fontconfig keeps three patterns of the font it was asked for until
// the process ends; Mesa keeps what its unloaded driver modules allocated: neither grows with use.
// Mesa's software renderer is not built for the thread sanitizer, which sees its threads' writes
// but not their locks; every report seen lay in that library alone.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:libfontconfig\nleak:<unknown module>\n"; }
extern "C" const char* __tsan_default_suppressions();
extern "C" const char* __tsan_default_suppressions() { return "race:swrast_dri.so\n"; }
