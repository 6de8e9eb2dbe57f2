// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/interface_driver.hpp>
#include <tegotae/device/vendor_library.hpp>

#include <tests/device/refusal.hpp>
#include <tests/lab/temporary_folder.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

namespace tegotae {
namespace {

using test::refusal;
using ::testing::AllOf;
using ::testing::HasSubstr;

constexpr const char* kFolderVariable = "TEGOTAE_TEST_VENDOR_FOLDER";

VendorLibraryNames names_of(std::vector<std::string> files) {
  return {"some-arm", "the Some SDK", std::move(files), kFolderVariable, "Install it."};
}

TEST(VendorLibrary, TakesTheFirstNameThatTheLoaderFinds) {
  const VendorLibrary library(names_of({"libno-such-arm.so", "libm.so.6", "libc.so.6"}));
  ASSERT_TRUE(library.is_loaded());
  EXPECT_EQ(library.tried(), (std::vector<std::string>{"libno-such-arm.so", "libm.so.6"}));
  EXPECT_THAT(library.file(), AllOf(HasSubstr("/"), HasSubstr("libm.so.6")));
  ASSERT_EQ(library.complaints().size(), 1u);
  EXPECT_THAT(library.complaints()[0], HasSubstr("libno-such-arm.so"));
  EXPECT_EQ(library.trouble(), "");
  EXPECT_NO_THROW(library.require_loaded());
}

TEST(VendorLibrary, FindsFunctions) {
  const VendorLibrary library(names_of({"libm.so.6"}));
  EXPECT_EQ(library.function<double(double)>("cos")(0.0), 1.0);
  ASSERT_NE(library.optional_function<double(double)>("cos"), nullptr);
  EXPECT_EQ(library.optional_function<double(double)>("armOpen"), nullptr);
}

TEST(VendorLibrary, AMissingFunctionIsRefusedWithFileNameAndMend) {
  const VendorLibrary library(names_of({"libm.so.6"}));
  EXPECT_THAT(refusal([&] { library.function<int(char)>("armOpen"); }),
              AllOf(HasSubstr("some-arm: "), HasSubstr(library.file()), HasSubstr("'armOpen'"),
                    HasSubstr("install a newer version of the Some SDK")));
}

TEST(VendorLibrary, WithoutALibraryEverythingIsRefusedWithWhatWasTried) {
  const VendorLibrary library(names_of({"libno-such-arm.so", "libno-such-arm.so.3"}));
  EXPECT_FALSE(library.is_loaded());
  EXPECT_EQ(library.file(), "");
  EXPECT_EQ(library.complaints().size(), 2u);
  EXPECT_EQ(library.trouble(),
            "some-arm: the Some SDK was not found (looked for libno-such-arm.so, libno-such-arm.so.3). Install it.");
  EXPECT_EQ(refusal([&] { library.require_loaded(); }), library.trouble());
  EXPECT_EQ(refusal([&] { library.function<int(char)>("armOpen"); }), library.trouble());
  EXPECT_EQ(library.optional_function<int(char)>("armOpen"), nullptr);
}

TEST(VendorLibrary, LooksIntoTheFolderOfTheVariableFirst) {
  const TemporaryFolder folder;
  ASSERT_EQ(setenv(kFolderVariable, folder.path().c_str(), 1), 0);
  const VendorLibrary library(names_of({"libm.so.6"}));
  ASSERT_EQ(unsetenv(kFolderVariable), 0);
  EXPECT_EQ(library.tried(), (std::vector<std::string>{(folder.path() / "libm.so.6").string(), "libm.so.6"}));
  EXPECT_TRUE(library.is_loaded());
}

TEST(VendorLibrary, AFileThatIsNoLibraryIsCalledBrokenNotAbsent) {
  const TemporaryFolder folder;
  const std::string file = folder.write("libno-such-arm.so", "this is no library");
  ASSERT_EQ(setenv(kFolderVariable, folder.path().c_str(), 1), 0);
  const VendorLibrary library(names_of({"libno-such-arm.so"}));
  ASSERT_EQ(unsetenv(kFolderVariable), 0);
  EXPECT_FALSE(library.is_loaded());
  EXPECT_THAT(library.trouble(), AllOf(HasSubstr("is there but cannot be loaded: " + file), HasSubstr("install what")));
}

}  // namespace
}  // namespace tegotae
