// Fontconfig keeps three patterns of the font it was asked for until the process ends; Mesa keeps
// what its unloaded driver modules allocated. Neither grows with use. Read by the leak sanitizer
// alone.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:libfontconfig\nleak:<unknown module>\n"; }
