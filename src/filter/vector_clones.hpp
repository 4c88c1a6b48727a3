// A function compiled once more for processors with wider registers; which one runs is decided when the program starts.
#pragma once

// AddressSanitizer cannot run before that decision, and Clang 14 does not know the attribute.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__)
#define SLIPPROOF_HAS_VECTOR_CLONES
#define SLIPPROOF_VECTOR_CLONES(...) [[gnu::target_clones(__VA_ARGS__, "default")]]
#else
#define SLIPPROOF_VECTOR_CLONES(...)
#endif

// Everything called is inlined, so that it is compiled for those registers too. Under sanitizers that takes minutes.
#if defined(__SANITIZE_ADDRESS__)
#define SLIPPROOF_FLATTEN
#else
#define SLIPPROOF_FLATTEN [[gnu::flatten]]
#endif
