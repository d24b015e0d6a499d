package tellosimulator.report;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.function.Function;

/** The formats in which other systems take grades. */
public enum GradeFormat {
  /** {@code junit.xml}, for CI services and Artemis. */
  JUNIT(JUnitXml::write),
  /** {@code gradescope/NAME/results.json} for each hand-in. */
  GRADESCOPE("results.json", GraderResults::gradescope),
  /** {@code classroom50/NAME/result.json} for each hand-in. */
  CLASSROOM50("result.json", GraderResults::classroom50),
  /** {@code autolab/NAME/scores.json} for each hand-in. */
  AUTOLAB("scores.json", GraderResults::autolab),
  /** {@code coderunner/NAME/result.json} for each hand-in. */
  CODERUNNER("result.json", GraderResults::codeRunner),
  /** {@code moodle-worksheet.csv} and {@code moodle-feedback.zip}. */
  MOODLE(MoodleFiles::write);

  /** Writes the files of a format into the folder of the results. */
  @FunctionalInterface
  private interface Writer {
    List<Path> write(ClassReport report) throws IOException;
  }

  private final Writer writer;

  GradeFormat(Writer writer) {
    this.writer = writer;
  }

  /** Creates a format with a file for each hand-in. */
  GradeFormat(String file, Function<GraderResults, String> form) {
    this.writer = report -> GraderResults.write(report, option(), file, form);
  }

  /** Returns the word for the command line. */
  public String option() {
    return name().toLowerCase(Locale.ROOT);
  }

  List<Path> write(ClassReport report) throws IOException {
    return writer.write(report);
  }
}
