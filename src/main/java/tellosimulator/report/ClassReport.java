package tellosimulator.report;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import tellosimulator.files.AtomicFile;
import tellosimulator.grade.GradedFlight;
import tellosimulator.grade.GradedHandIn;
import tellosimulator.grade.Grades;
import tellosimulator.recording.RecordedFlight;
import tellosimulator.recording.UnreadableRecordingException;
import tellosimulator.words.Printable;

/**
 * The pages about the grades of a class: {@code index.html} for the teacher, and a folder {@code
 * feedback/NAME} for each hand-in with {@code feedback.html} and the reports of its flights. No
 * page loads anything from a network. Not thread-safe.
 */
public final class ClassReport {

  /** The page of the class. */
  public static final String INDEX = "index.html";

  /** The page with the points, but without names. */
  public static final String LEADERBOARD = "leaderboard.html";

  /** The page for the author of a hand-in. */
  public static final String FEEDBACK = "feedback.html";

  private final Grades grades;
  private final Path folder;
  private final GradeWords words;

  /**
   * Creates the pages without writing them.
   *
   * @param folder the folder of the results, with the recordings of the flights
   */
  public ClassReport(Grades grades, Path folder, ReportTexts texts) {
    this.grades = grades;
    this.folder = folder;
    words = new GradeWords(grades, texts);
  }

  Grades grades() {
    return grades;
  }

  GradeWords words() {
    return words;
  }

  /** Returns the folder of the results. */
  Path folder() {
    return folder;
  }

  /** Returns the folder with the feedback on a hand-in; if it has no name, that of the results. */
  Path feedback(GradedHandIn handIn) {
    return handIn.folder().isEmpty() ? folder : folder.resolve("feedback").resolve(handIn.folder());
  }

  /**
   * Writes all pages.
   *
   * @param leaderboard whether there is also a page with the points, but without names
   * @return the page of the class
   * @throws IOException if a page cannot be written
   */
  public Path write(boolean leaderboard) throws IOException {
    writeFeedback();
    if (leaderboard) {
      write(folder.resolve(LEADERBOARD), new ClassPage(this).leaderboard());
    } else {
      Files.deleteIfExists(folder.resolve(LEADERBOARD));
    }
    Path index = folder.resolve(INDEX);
    write(index, new ClassPage(this).html(leaderboard));
    return index;
  }

  /**
   * Writes the page for each hand-in. A flight whose recording cannot be read has no report.
   *
   * @throws IOException if a page cannot be written
   */
  public void writeFeedback() throws IOException {
    for (GradedHandIn handIn : grades.handIns()) {
      Files.createDirectories(feedback(handIn));
      for (GradedFlight flight : handIn.flights()) {
        writeReport(flight, report(handIn, flight));
      }
    }
    // after all recordings have been read, because they translate each other's sentences
    for (GradedHandIn handIn : grades.handIns()) {
      write(feedback(handIn).resolve(FEEDBACK), new FeedbackPage(this, handIn).html());
    }
  }

  /** Returns the file for the report of a flight. */
  Path report(GradedHandIn handIn, GradedFlight flight) {
    return feedback(handIn).resolve(flight.name() + ".html");
  }

  private void writeReport(GradedFlight flight, Path to) throws IOException {
    Files.deleteIfExists(to);
    if (flight.recording().isEmpty()) {
      return;
    }
    try {
      RecordedFlight recorded = RecordedFlight.read(folder.resolve(flight.recording()));
      words.learn(recorded);
      new FlightReport(recorded, words.texts()).write(to);
    } catch (UnreadableRecordingException e) {
      // the page says that there is no report
    }
  }

  /**
   * Returns a page with the style that all pages of grades share.
   *
   * @param script the script; empty if the page runs none
   */
  HtmlTemplate page(String resource, String title, String script) {
    String style = HtmlTemplate.resource("report.css") + "\n" + HtmlTemplate.resource("class.css");
    return HtmlTemplate.page(resource, words.texts())
        .text("title", Printable.of(title))
        .text("heading", Printable.of(grades.assignment()))
        .ownCode(style, script);
  }

  static void write(Path file, String text) throws IOException {
    Files.createDirectories(file.toAbsolutePath().getParent());
    AtomicFile.write(file, out -> out.write(text.getBytes(StandardCharsets.UTF_8)));
  }

  /**
   * Writes the files of a format.
   *
   * @return the files that were written
   * @throws IOException if a file cannot be written, or these hand-ins have no place in the format
   */
  public List<Path> write(GradeFormat format) throws IOException {
    return format.write(this);
  }
}
