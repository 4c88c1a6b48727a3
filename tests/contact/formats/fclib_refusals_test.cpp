// What must not be followed or believed in FCLIB's files.
#include "base/input/text_file.hpp"
#include "contact/formats/fclib_writer.hpp"

using namespace slipproof;
using namespace slipproof::test;

#ifdef SLIPPROOF_HDF5

TEST_CASE("strange HDF5 files are refused with the path") {
  const std::string W = "/fclib_local/W", vectors = "/fclib_local/vectors";
  struct Strange {
    Write change;
    std::string message;
  };
  const auto gone = [](const std::string& path) { return [path](const Hdf5Writer& out) { out.remove(path); }; };
  const auto integers = [](const std::string& path, const std::vector<long long>& values, hid_t type = H5T_STD_I64LE) {
    return [=](const Hdf5Writer& out) { out.integers(path, values, type); };
  };
  const auto reals = [](const std::string& path, const Numbers& values) {
    return [=](const Hdf5Writer& out) { out.reals(path, values); };
  };
  const auto made = [](const std::string& path, const std::vector<hsize_t>& sizes,
                       const std::function<void(hid_t)>& how) {
    return [=](const Hdf5Writer& out) {
      const hid_t properties = H5Pcreate(H5P_DATASET_CREATE);
      how(properties);
      out.set(path, H5T_IEEE_F64LE, sizes, H5T_NATIVE_DOUBLE, nullptr, properties);
      H5Pclose(properties);
    };
  };
  const std::vector<Strange> files = {
      {gone(W), W + "/m: found nothing, expected integers"},
      {gone(W + "/x"), W + "/x: found nothing, expected numbers"},
      {gone(W + "/nz"), W + "/nz: found nothing, expected integers"},
      {gone(vectors), vectors + "/mu: found nothing, expected numbers"},
      {gone(vectors + "/q"), vectors + "/q: found nothing, expected numbers"},
      {gone("/fclib_local"), "found neither /fclib_local nor /fclib_global, expected one of them"},
      {[](const Hdf5Writer& out) { out.remove("/fclib_local"), out.group("/fclib_global_rolling"); },
       "/fclib_global_rolling: found rolling friction, which is not judged, expected /fclib_local or /fclib_global"},
      {integers("/fclib_local/spacedim", {5}), "/fclib_local/spacedim: found 5, expected 2 or 3"},
      {integers("/fclib_local/spacedim", {3}), "found 2 components, expected a multiple of the dimension 3"},
      {integers("/fclib_local/spacedim", {2, 2}), "/fclib_local/spacedim: found 2 numbers, expected one"},
      {reals("/fclib_local/spacedim", {2}), "/fclib_local/spacedim: found another type, expected integers"},
      {integers(W + "/m", {3}), W + "/m: found 3, expected 2, the length of the vectors"},
      {integers(W + "/n", {1LL << 40}), W + "/n: found 1099511627776, expected 2, the length of the vectors"},
      {integers(W + "/m", {-1}), W + "/m: found -1, expected 2, the length of the vectors"},
      {integers(W + "/m", {-1}, H5T_STD_U64LE), W + "/m: found"},
      {integers(W + "/nz", {-3}), W + "/nz: found -3, expected a number of triplets, -1 or -2"},
      {integers(W + "/nz", {1LL << 40}), W + "/nz: found 1099511627776, expected at most 3, the length of x"},
      {integers(W + "/nz", {3}), W + "/p: found the index 2, expected one from 0 to 2 - 1"},
      {integers(W + "/p", {0, 3}),
       W + "/p: found 2 numbers, expected 3, where each row starts and where the last one ends"},
      {integers(W + "/p", {0, 3, 2}), W + "/p: found starts that do not increase from 0 to at most 3"},
      {integers(W + "/p", {0, 2, 4}), W + "/p: found starts that do not increase from 0 to at most 3"},
      {integers(W + "/p", {-1, 2, 3}), W + "/p: found starts that do not increase from 0 to at most 3"},
      {integers(W + "/p", {1, 2, 3}), W + "/p: found starts that do not increase from 0 to at most 3"},
      {integers(W + "/i", {0, 1}), W + "/i: found 2 numbers, expected 3"},
      {integers(W + "/i", {0, 2, 1}), W + "/i: found the index 2, expected one from 0 to 2 - 1"},
      {integers(W + "/i", {0, -1, 1}), W + "/i: found the index -1, expected one from 0 to 2 - 1"},
      {integers(W + "/i", {1LL << 40, 1, 1}), W + "/i: found the index 1099511627776, expected one from 0 to 2 - 1"},
      {integers(W + "/i", {1, 1, 1}), W + ": found the entry in row 1 and column 2 twice, expected it once"},
      {reals(W + "/x", {4, std::nan(""), 5}), "W[1][2]: found NaN, expected a finite number"},
      {reals(W + "/x", {4, 3, HUGE_VAL}), "W[2][2]: found an infinity, expected a finite number"},
      {reals(W + "/x", {4, 3}), W + "/p: found starts that do not increase from 0 to at most 2"},
      {integers(W + "/x", {4, 3, 5}), W + "/x: found another type, expected numbers"},
      {reals(vectors + "/q", {1, std::nan("")}), "q[2]: found NaN, expected a finite number"},
      {reals(vectors + "/mu", {-0.5}), "mu[1]: found -0.5, expected a coefficient of friction, which is not negative"},
      {reals(vectors + "/mu", {std::nan("")}), "mu[1]: found NaN, expected a finite number"},
      {reals(vectors + "/mu", {1, 1}), "mu: found 2 numbers, expected 1"},
      {reals(vectors + "/q", {1, 2, 3, 4}), W + "/m: found 2, expected 4, the length of the vectors"},
      {[&](const Hdf5Writer& out) {
         const Numbers q = {1, 2};
         out.set(vectors + "/q", H5T_IEEE_F64LE, {2, 1}, H5T_NATIVE_DOUBLE, q.data());
       },
       vectors + "/q: found 2 dimensions, expected a list of numbers"},
      {made(vectors + "/q", {hsize_t{1} << 40}, [](hid_t) {}),
       vectors + "/q: found a size of 1099511627776, for which the file has no data"},
      {made(vectors + "/q", {2}, [](hid_t) {}), vectors + "/q: found a size of 2, for which the file has no data"},
      {made(vectors + "/q", {2}, [](hid_t properties) { H5Pset_external(properties, "/etc/hostname", 0, 16); }),
       vectors + "/q: found numbers in another file, expected them in this one"},
      {[&](const Hdf5Writer& out) {
         const hid_t properties = H5Pcreate(H5P_DATASET_CREATE);
         const hsize_t two = 2;
         const hid_t space = H5Screate_simple(1, &two, nullptr);
         H5Pset_virtual(properties, space, "/etc/hostname", "/x", space);
         out.set(vectors + "/q", H5T_IEEE_F64LE, {2}, H5T_NATIVE_DOUBLE, nullptr, properties);
         H5Sclose(space);
         H5Pclose(properties);
       },
       vectors + "/q: found a virtual data set, expected the data itself"},
      {[&](const Hdf5Writer& out) {
         const hid_t properties = H5Pcreate(H5P_DATASET_CREATE);
         const hsize_t two = 2;
         const Numbers q = {1, 2};
         H5Pset_chunk(properties, 1, &two);
         H5Pset_deflate(properties, 9);
         out.set(vectors + "/q", H5T_IEEE_F64LE, {2}, H5T_NATIVE_DOUBLE, q.data(), properties);
         H5Pclose(properties);
       },
       vectors + "/q: found numbers in chunks, expected them in one piece, as h5repack --layout=CONTI writes them"},
      {[&](const Hdf5Writer& out) {
         out.remove(W);
         H5Lcreate_soft("/fclib_local/W", out.file(), W.c_str(), H5P_DEFAULT, H5P_DEFAULT);
       },
       W + ": found a link to another path, expected the data itself"},
      {[&](const Hdf5Writer& out) {
         out.remove(W);
         H5Lcreate_external("/etc/hostname", "/W", out.file(), W.c_str(), H5P_DEFAULT, H5P_DEFAULT);
       },
       W + ": found a link out of the file, expected the data itself"},
      {[&](const Hdf5Writer& out) {
         out.remove(W + "/m");
         H5Lcreate_hard(out.file(), "/fclib_local", out.file(), (W + "/m").c_str(), H5P_DEFAULT, H5P_DEFAULT);
       },
       W + "/m: found no data set, expected integers"},
      {[&](const Hdf5Writer& out) {
         out.remove(W);
         out.reals(W, {1});
       },
       W + ": found no group, expected a group"},
      {[&](const Hdf5Writer& out) {
         const hid_t type = H5Tvlen_create(H5T_NATIVE_DOUBLE);
         out.set(vectors + "/q", type, {2}, type, nullptr);
         H5Tclose(type);
       },
       vectors + "/q: found another type, expected numbers"},
      {[&](const Hdf5Writer& out) {
         const hid_t type = H5Tcreate(H5T_COMPOUND, 8);
         H5Tinsert(type, "x", 0, H5T_NATIVE_DOUBLE);
         out.set(vectors + "/q", type, {2}, type, nullptr);
         H5Tclose(type);
       },
       vectors + "/q: found another type, expected numbers"},
      {[&](const Hdf5Writer& out) {
         const hid_t type = H5Tcopy(H5T_STD_I32LE);
         H5Tset_precision(type, 17);
         const std::vector<long long> two = {2};
         out.set(W + "/m", type, {1}, H5T_NATIVE_LLONG, two.data());
         H5Tclose(type);
       },
       W + "/m: found another type, expected integers"},
      {[](const Hdf5Writer& out) { out.group("/solution"); },
       "/solution: found neither r nor u, expected a solver's answer"},
      {[](const Hdf5Writer& out) {
         write_solution(out, {1, 2, 3}, {1, 2});
       },
       "/solution/r: found 3 numbers, expected 2"},
      {[](const Hdf5Writer& out) {
         out.group("/guesses");
         out.integers("/guesses/number_of_guesses", {1LL << 40}, H5T_STD_I64LE);
       },
       "/guesses/number_of_guesses: found 1099511627776, expected at most 1, as there are objects in /guesses"},
      {[](const Hdf5Writer& out) {
         out.group("/guesses");
         out.integers("/guesses/number_of_guesses", {1});
       },
       "/guesses/1: found nothing, expected a solver's answer"},
      {[](const Hdf5Writer& out) {
         out.group("/guesses");
         out.integers("/guesses/number_of_guesses", {1});
         H5Lcreate_hard(out.file(), "/", out.file(), "/guesses/1", H5P_DEFAULT, H5P_DEFAULT);
       },
       "/guesses/1: found neither r nor u, expected a solver's answer"},
  };
  const Folder folder;
  for (const Strange& file : files) {
    CAPTURE(file.message);
    const std::string said = problem_refusal(written(folder, write_local, file.change));
    CHECK_MESSAGE(said.starts_with("FILE: " + file.message), said);
  }
}

TEST_CASE("HDF5 files that are cut off anywhere are refused") {
  const Folder folder;
  const std::string whole = read_text_file(written(folder, write_local));
  for (std::size_t size = 0; size < whole.size(); size += 1 + size / 50) {
    CAPTURE(size);
    CHECK_FALSE(problem_refusal(folder.write("cut", whole.substr(0, size))).empty());
  }
  CHECK_FALSE(problem_refusal(folder.write("cut", whole.substr(0, whole.size() - 1))).empty());
}

#endif
