// Sweeps: one row per scene. Finished rows survive an interruption.

#include <algorithm>

#include "impact_sim.hpp"

namespace impact::host {
namespace {

class ImpactSimSweep : public ImpactSim {
 protected:
  ImpactSimSweep() {
    std::string text = "restitution,clearance,law\n";
    for (const char* law : {"hunt-crossley", "hooke-newton"})
      for (const char* clearance : {"0.01", "0.02", "0.04"})
        for (const char* restitution : {"0.5", "0.68", ""})
          text += std::string(restitution) + "," + clearance + "," + law + "\n";
    write(file("scenes.csv"), text);
    EXPECT_EQ(run(sweep + "--output whole.csv").code, 0);
    whole = read(file("whole.csv"));
  }
  const std::string sweep = "--sweep scenes.csv --duration 0.5 --newmark moment ";
  std::string whole;
};

TEST_F(ImpactSimSweep, WritesARowPerSceneInTheirOrder) {
  const auto lines = lines_of(whole);
  ASSERT_THAT(lines, SizeIs(19));
  EXPECT_EQ(
      lines[0],
      "scene,duration,newmark,restitution,clearance,law,max_x1,rms_x1,attenuation,energy_dissipated,impacts,fault");
  EXPECT_THAT(lines[1], StartsWith("1,0.5,moment,0.5,0.01,hunt-crossley,"));
  EXPECT_THAT(lines[18], StartsWith("18,0.5,moment,,0.04,hooke-newton,"));
}

TEST_F(ImpactSimSweep, SummarizesWhatTheTrajectoriesShow) {
  const auto largest_and_rms = [&](const std::string& arguments) {
    double largest = 0, squares = 0;
    const auto rows = rows_of(run("--newmark moment --numeric float64 --duration 0.5 " + arguments).out);
    for (const auto& row : rows) {
      largest = larger(largest, std::abs(row[1]));
      squares += row[1] * row[1];
    }
    return std::pair(largest, std::sqrt(squares / static_cast<double>(rows.size())));
  };
  const auto [largest, rms] = largest_and_rms("--restitution 0.68 --clearance 0.02");
  const auto [bare, bare_rms] = largest_and_rms("--clearance 1000");
  const auto row = split(lines_of(whole)[5], ',');
  // Both sum the same 5001 doubles, in another order, so they differ by at most 5001 roundings.
  EXPECT_EQ(std::stod(row[6]), largest);
  EXPECT_NEAR(std::stod(row[7]), rms, 5001 * 1.2e-16 * rms);
  EXPECT_NEAR(std::stod(row[8]), 1 - largest / bare, 1e-15);
  EXPECT_GT(std::stod(row[9]), 0);
  EXPECT_GE(std::stol(row[10]), 2);
}

TEST_F(ImpactSimSweep, ResumesWhereItWasInterrupted) {
  const size_t header_end = whole.find('\n') + 1;
  for (const size_t length :
       {size_t{0}, header_end - 5, header_end, whole.size() / 2, whole.size() - 1, whole.size()}) {
    write(file("part.csv"), whole.substr(0, length));
    EXPECT_EQ(run(sweep + "--output part.csv").code, 0);
    EXPECT_EQ(read(file("part.csv")), whole) << "from " << length << " bytes";
  }
}

TEST_F(ImpactSimSweep, KeepsTheRowsThatAreThere) {
  // A mark in a finished row remains, so that scene was not run again.
  std::string marked = whole;
  const size_t impacts = marked.rfind(',', marked.find('\n', marked.find("\n4,") + 1));
  marked.insert(impacts, "99");
  const size_t third_from_last = marked.rfind("\n16,") + 1;
  write(file("part.csv"), marked.substr(0, third_from_last));
  EXPECT_EQ(run(sweep + "--output part.csv").code, 0);
  EXPECT_EQ(read(file("part.csv")), marked);
}

TEST_F(ImpactSimSweep, KilledInTheMiddleLosesNothing) {
  // The signal may come before, during or after the work. Only complete rows remain, and the next run adds the others.
  const std::string slow = "--sweep scenes.csv --duration 5 --newmark moment ";
  EXPECT_EQ(run(slow + "--output reference.csv").code, 0);
  for (const char* delay : {"0.02", "0.1", "0.3"}) {
    run(slow + "--output part.csv", "", std::string("& sleep ") + delay + "; kill -KILL $!; wait $!");
    const std::string left = fs::exists(file("part.csv")) ? read(file("part.csv")) : "";
    const auto rows = lines_of(left.substr(0, left.rfind('\n') + 1));
    EXPECT_EQ(run(slow + "--output part.csv").code, 0);
    const std::string done = read(file("part.csv"));
    EXPECT_EQ(done, read(file("reference.csv")));
    for (const std::string& row : rows) EXPECT_THAT(done, HasSubstr(row + "\n"));
    fs::remove(file("part.csv"));
  }
}

TEST_F(ImpactSimSweep, ShardsTogetherAreTheWhole) {
  for (const char* shard : {"3/3", "1/3", "2/3"})
    EXPECT_EQ(run(sweep + "--output joined.csv --shard " + shard).code, 0);
  EXPECT_EQ(read(file("joined.csv")), whole);
  const auto lines = lines_of(run(sweep + "--shard 2/3").out);
  ASSERT_THAT(lines, SizeIs(1 + 6));
  for (size_t i = 1; i < lines.size(); ++i) {
    EXPECT_EQ(std::stol(lines[i]) % 3, 2);
    EXPECT_THAT(whole, HasSubstr("\n" + lines[i] + "\n"));
  }
}

TEST_F(ImpactSimSweep, RefusesAFileOfSomethingElse) {
  const auto refuses = [&](const std::string& text, const std::string& arguments) {
    write(file("other.csv"), text);
    expect_refusal(arguments + " --output other.csv", "--output other.csv");
    EXPECT_EQ(read(file("other.csv")), text);
  };
  refuses("precious\n", sweep);
  refuses("precious", sweep);
  refuses(whole, "--sweep scenes.csv --duration 0.6 --newmark moment ");
  refuses(whole + "19,0.5,moment,0.5,0.01,hunt-crossley,0,0,0,0,0,\n", sweep);
  refuses("\n", sweep);
}

// A finished row is valid only for its samples. A copy of their file with another time stamp is the same.
TEST_F(ImpactSimSweep, RowsOfADriveFileThatHasChangedAreNotReused) {
  const auto write_forces = [this](int force) { write_samples("forces", 100, [=](int) { return force; }); };
  write_forces(1);
  write(file("driven.csv"), "drive-file,clearance\nforces,0.01\n,0.01\nforces,0.02\n");
  const std::string driven = "--sweep driven.csv --step 1e-4 --duration 0.01 --newmark moment --output rows.csv";
  EXPECT_EQ(run(driven).code, 0);
  const std::string rows = read(file("rows.csv"));
  EXPECT_THAT(rows, HasSubstr(",drive-file,clearance,drive_samples,max_x1,"));
  write_forces(1);
  EXPECT_EQ(run(driven).code, 0);
  EXPECT_EQ(read(file("rows.csv")), rows);
  write_forces(2);
  const Result result = run(driven);
  EXPECT_EQ(result.code, 2);
  EXPECT_THAT(result.err, HasSubstr("--output rows.csv line 2"));
  EXPECT_THAT(result.err, HasSubstr("with the same drive files"));
  EXPECT_EQ(read(file("rows.csv")), rows);
}

TEST_F(ImpactSimSweep, ABadLineIsRefusedBeforeAnythingRuns) {
  const auto refusal = [&](const std::string& text) {
    write(file("bad.csv"), text);
    const Result result = run("--sweep bad.csv --output new.csv");
    EXPECT_EQ(result.code, 2);
    EXPECT_THAT(lines_of(result.err), SizeIs(1));
    EXPECT_FALSE(fs::exists(file("new.csv")));
    return result.err;
  };
  EXPECT_THAT(refusal("clearance\n0.02\n\n-1\n"),
              HasSubstr("bad.csv line 4: --clearance -1: allowed: a number from 0"));
  EXPECT_THAT(refusal("clearance,law\n0.02\n"), HasSubstr("line 2: a line of 1 cells: allowed: 2"));
  EXPECT_THAT(refusal("clearence\n0.02\n"),
              HasSubstr("line 1: --clearence: allowed: the options of --help; --clearance?"));
  EXPECT_THAT(refusal("output\nx.csv\n"), HasSubstr("line 1: --output"));
  EXPECT_THAT(refusal("clearance,\n0.01,\n"), HasSubstr("line 1: a column without a name"));
  EXPECT_THAT(refusal("x1,x1\n0,0\n"), HasSubstr("line 2: --x1 0: allowed: once"));
  EXPECT_THAT(refusal("drive-file\n/dev/null\n"),
              HasSubstr("line 2: --drive-file /dev/null: allowed: a file that can be read twice"));
  EXPECT_THAT(refusal(""), HasSubstr("--sweep bad.csv"));
}

TEST_F(ImpactSimSweep, ChoosesAStepForEachScene) {
  write(file("few.csv"), "contact-stiffness\n3e4\n3e8\n");
  const Result result = succeed("--sweep few.csv --duration 1");
  EXPECT_THAT(result.err, HasSubstr("steps of "));
  EXPECT_THAT(result.err, HasSubstr(" to 0.001 s"));
  EXPECT_THAT(result.err, HasSubstr("than the default and the default --contact-damping: 2."));
  EXPECT_THAT(succeed("--sweep few.csv --duration 0.1 --quiet").err, IsEmpty());
  auto scenes = lines_of(result.out);  // rows are in the order in which scenes finish
  std::sort(scenes.begin(), scenes.end());
  for (const char* scene : {"3e4", "3e8"}) {
    double largest = 0;
    for (const auto& row : rows_of(run(std::string("--duration 1 --contact-stiffness ") + scene).out))
      largest = larger(largest, std::abs(row[1]));
    const auto row = split(scenes[scene[2] == '4' ? 0 : 1], ',');
    EXPECT_EQ(std::stod(row[3]), largest) << scene;
  }
}

// The main mass oscillates by 0.5 rad per step. EnergyConsistent accepts that, and so must the mass without absorber.
TEST_F(ImpactSimSweep, RunsWhatItsStepperTakes) {
  write(file("stiff.csv"), "main-stiffness\n1e6\n1000\n");
  succeed("--sweep stiff.csv --newmark energy --contact-stiffness 1e11 --step 5e-4 --duration .1 --output rows.csv");
  const auto rows = lines_of(read(file("rows.csv")));
  ASSERT_THAT(rows, SizeIs(3));
  for (size_t n = 1; n < rows.size(); ++n) {
    const auto header = split(rows[0], ','), row = split(rows[n] + " ", ',');
    ASSERT_EQ(row.size(), header.size()) << rows[n];
    EXPECT_FALSE(row[row.size() - 4].empty()) << "the attenuation of " << rows[n];
  }
}

TEST_F(ImpactSimSweep, ANameWithACommaIsOneCell) {
  write(file("a,b.txt"), "1\n1\n1\n");
  write(file("few.csv"), "clearance\n0.02\n0.03\n");
  const std::string driven = "--sweep few.csv --drive-file a,b.txt --step 1e-4 --newmark moment --output rows.csv";
  EXPECT_EQ(run(driven).code, 0);
  const auto rows = lines_of(read(file("rows.csv")));
  EXPECT_EQ(split(rows[1], ',').size(), split(rows[0], ',').size() - (rows[1].back() == ',' ? 1 : 0));
  EXPECT_EQ(run(driven).code, 0) << "what it has written itself";
}

TEST_F(ImpactSimSweep, OptionsOfTheCommandLineApplyToEveryScene) {
  write(file("few.csv"), "restitution\n0.5\n0.9\n");
  const Result result = succeed("--sweep few.csv --impact-speed 1.5 --duration 0.1");
  EXPECT_THAT(result.out, StartsWith("scene,impact-speed,duration,restitution,max_x1,"));
  EXPECT_THAT(result.out, HasSubstr("\n2,1.5,0.1,0.9,"));
}

TEST_F(ImpactSimSweep, AFullDiskIsExitCodeOne) {
  EXPECT_EQ(run(sweep + "--output /dev/full").code, 1);
  EXPECT_EQ(run(sweep, "", "> /dev/full").code, 1);
}

// R's write.csv and spreadsheets write cells in quotes, which may contain commas, and a plus before a number.
TEST_F(ImpactSimSweep, QuotedCellsAndAPlusAreRead) {
  write(file("plain.csv"), "v2,clearance,law\n0.5,0.01,hertz\n,0.02,hooke-newton\n");
  write(file("quoted.csv"),
        "\"v2\",\"clearance\", \"law\"\r\n+0.5,\"+1e-2\",\"hertz\"\r\n\"\",0.02,\"hooke-newton\"\r\n");
  const auto results = [&](const char* name) {
    succeed(std::string("--duration 0.1 --output rows --sweep ") + name);
    const auto rows = lines_of(read(file("rows")));
    fs::remove(file("rows"));
    EXPECT_THAT(rows, SizeIs(3));
    return rows.at(1).substr(rows.at(1).find(",h")) + rows.at(2).substr(rows.at(2).find(",h"));
  };
  EXPECT_EQ(results("quoted.csv"), results("plain.csv"));
  write(file("a,b"), "1\n2\n3\n");
  write(file("named.csv"), "drive-file,x1\n\"a,b\",0\n\"a\"\"b\",0\n");
  EXPECT_THAT(run("--sweep named.csv").err, HasSubstr("line 3: --drive-file a\"b: allowed: a file that can be read"));
}

}  // namespace
}  // namespace impact::host
