"""What the repair of a wheel concludes from the output of objdump and ldd."""

import importlib.util
from pathlib import Path

import pytest

FILE = Path(__file__).resolve().parents[3] / "src/faces/python/wheel/repair.py"
SPEC = importlib.util.spec_from_file_location("repair", FILE)
repair = importlib.util.module_from_spec(SPEC)
SPEC.loader.exec_module(repair)


def undefined(*versions):
    return "".join(f"0000000000000000      DF *UND*  0000000000000000 ({v}) some_name\n" for v in versions)


@pytest.mark.parametrize("versions, glibc", [
    ([], (2, 17)), (["GLIBC_2.2.5", "GLIBC_2.14"], (2, 17)), (["GLIBC_2.34", "GLIBC_2.9"], (2, 34)),
    (["GLIBC_2.28", "GLIBCXX_3.4.30"], (2, 35)), (["GLIBCXX_3.4.23"], (2, 27)), (["CXXABI_1.3.13", "GCC_3.0"], (2, 34)),
    (["GCC_12.0.0"], (2, 35)), (["GLIBC_2.36", "GLIBCXX_3.4.30"], (2, 36)),
])
def test_the_tag_promises_all_versions(versions, glibc):
    assert repair.least_glibc(undefined(*versions)) == glibc


def test_what_the_module_defines_does_not_count():
    assert repair.least_glibc("00000000000a2c40 g    DF .text  0000000000000051 (GLIBC_2.36) own_name\n") == (2, 17)


def test_a_version_that_no_tag_promises_is_refused():
    with pytest.raises(SystemExit, match="GLIBCXX_3.4.99"):
        repair.least_glibc(undefined("GLIBCXX_3.4.99"))


def test_libraries_beyond_the_promised_ones_are_taken_along():
    listing = """	linux-vdso.so.1 (0x00007ffd)
	libtbb.so.12 => /lib/libtbb.so.12 (0x00007f0a)
	libstdc++.so.6 => /lib/libstdc++.so.6 (0x00007f0b)
	libc.so.6 => /lib/libc.so.6 (0x00007f0c)
	/lib64/ld-linux-x86-64.so.2 (0x00007f0d)
"""
    assert repair.libraries(listing) == {"libtbb.so.12": Path("/lib/libtbb.so.12")}


def test_symbols_that_are_not_found_are_named_but_for_those_of_python():
    assert repair.libraries("undefined symbol: PyList_New (./_core.so)\nundefined symbol: _Py_NoneStruct (./_core.so)\n") == {}
    with pytest.raises(SystemExit, match="not found: __gmpz_lost$"):
        repair.libraries("undefined symbol: PyList_New (./_core.so)\nundefined symbol: __gmpz_lost (./_core.so)\n")


def test_a_library_that_is_not_found_is_named():
    with pytest.raises(SystemExit, match="liblost.so.1"):
        repair.libraries("	liblost.so.1 => not found\n")
