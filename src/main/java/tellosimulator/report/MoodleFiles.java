package tellosimulator.report;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDateTime;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import tellosimulator.files.AtomicFile;
import tellosimulator.grade.GradedHandIn;
import tellosimulator.grade.Grades;

/**
 * The grading worksheet and the feedback files that a Moodle assignment takes. Source: Moodle,
 * {@code mod/assign/feedback/offline/importgradeslib.php} (columns by their English headings) and
 * {@code mod/assign/feedback/file/importziplib.php} (folders as in the downloaded zip).
 */
final class MoodleFiles {

  /** The folder or file of a hand-in in the zip from Moodle, with the number of the participant. */
  private static final Pattern FOLDER =
      Pattern.compile("(?<folder>[^_]*_(?<id>[0-9]+)_assignsubmission_file_?).*");

  /** The same at all times, so that equal grades give equal files. */
  private static final LocalDateTime TIME = LocalDateTime.of(1980, 1, 1, 0, 0);

  private static final List<Object> COLUMNS =
      List.of("Identifier", "Full name", "Grade", "Last modified (grade)", "Feedback comments");

  private MoodleFiles() {}

  static List<Path> write(ClassReport report) throws IOException {
    List<List<Object>> rows = new ArrayList<>();
    for (GradedHandIn handIn : report.grades().handIns()) {
      Matcher folder = FOLDER.matcher(handIn.original());
      if (folder.matches()) {
        String comments =
            report.words().courses(handIn).stream()
                .map(each -> report.words().name(each) + "\n" + report.words().reasons(each))
                .collect(Collectors.joining("\n\n"));
        rows.add(
            List.of(
                "Participant " + folder.group("id"),
                handIn.name(),
                handIn.grade(),
                "",
                Markup.of("%s", comments).text().replace("\n", "<br>")));
      }
    }
    if (rows.isEmpty()) {
      throw new IOException(
          "no hand-in is from Moodle, whose names end with _123_assignsubmission_file");
    }
    Path worksheet = report.folder().resolve("moodle-worksheet.csv");
    ClassReport.write(worksheet, Grades.table(COLUMNS, rows.stream()));
    Path feedback = report.folder().resolve("moodle-feedback.zip");
    AtomicFile.write(feedback, out -> zip(report, out));
    return List.of(worksheet, feedback);
  }

  private static void zip(ClassReport report, OutputStream out) throws IOException {
    ZipOutputStream zip = new ZipOutputStream(out, StandardCharsets.UTF_8);
    for (GradedHandIn handIn : report.grades().handIns()) {
      Matcher folder = FOLDER.matcher(handIn.original());
      if (folder.matches()) {
        add(zip, folder.group("folder"), report.feedback(handIn));
      }
    }
    zip.finish(); // the caller closes the file
  }

  private static void add(ZipOutputStream zip, String name, Path folder) throws IOException {
    try (Stream<Path> files = Files.list(folder)) {
      for (Path file : files.sorted().toList()) {
        ZipEntry entry = new ZipEntry(name + "/" + file.getFileName());
        entry.setTimeLocal(TIME);
        zip.putNextEntry(entry);
        Files.copy(file, zip);
        zip.closeEntry();
      }
    }
  }
}
