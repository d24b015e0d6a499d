package tellosimulator.grade;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import tellosimulator.files.IoReason;
import tellosimulator.files.TemporaryFolder;
import tellosimulator.launcher.Confinement;
import tellosimulator.scenario.Assignment;
import tellosimulator.scenario.AssignmentFile;
import tellosimulator.scenario.ScenarioException;
import tellosimulator.scenario.ScenarioFile;

/**
 * Grades the hand-ins of a class. {@link #close} is thread-safe; all other methods are called on
 * one thread.
 */
public final class Grading implements AutoCloseable {

  private final Request request;
  private final Assignment assignment;
  private final List<SeededCourse> courses;
  private volatile Optional<Grader> grader = Optional.empty();
  private volatile boolean closed;

  /**
   * What is graded.
   *
   * @param assignment the file of the assignment
   * @param handIns a folder, a zip, or a single file
   * @param into the folder of the results
   * @param roster a CSV file with the names of the class
   * @param only the name of the only hand-in to grade; empty for all
   * @param shard which part of the class is graded
   */
  public record Request(
      Path assignment,
      Path handIns,
      Path into,
      Optional<Path> roster,
      Optional<String> only,
      Shard shard) {}

  /**
   * A part of a class: every {@code of}-th hand-in.
   *
   * @param index from 1 to {@code of}
   */
  public record Shard(int index, int of) {

    public static final Shard ALL = new Shard(1, 1);

    public Shard {
      if (index < 1 || index > of) {
        throw new IllegalArgumentException(
            "a shard is a number from 1, and how many there are, such as 1/4");
      }
    }
  }

  private Grading(Request request, Assignment assignment, List<SeededCourse> courses) {
    this.request = request;
    this.assignment = assignment;
    this.courses = List.copyOf(courses);
  }

  /**
   * Reads an assignment and its courses.
   *
   * @param errors receives a sentence, or a line with its place, for each error in these files
   * @return empty if there are errors
   */
  public static Optional<Grading> open(Request request, List<String> errors) {
    try {
      Assignment read = AssignmentFile.read(request.assignment());
      List<SeededCourse> courses = SeededCourse.of(read, errors);
      return errors.isEmpty() ? Optional.of(new Grading(request, read, courses)) : Optional.empty();
    } catch (ScenarioException e) {
      errors.add(e.getMessage());
      return Optional.empty();
    }
  }

  /**
   * Returns the hand-ins, without flying any. Their copies are gone.
   *
   * @throws IOException if they cannot be read; the message is a clause
   */
  public List<HandIn> found() throws IOException {
    try (TemporaryFolder scratch = TemporaryFolder.create("tello-grade")) {
      return selected(handIns(scratch.path()));
    }
  }

  /**
   * Flies and grades the hand-ins, and writes the grades. Flights that are there already, of the
   * same files, are not repeated. If this is closed meanwhile, the grades contain what is done.
   *
   * @param simulator the command that starts a simulator, without options
   * @param jobs the number of flights at a time
   * @param weaker receives a sentence before the first flight if this system cannot confine
   *     programs
   * @throws IOException if a file cannot be read or written; the message is a clause
   */
  public Grades grade(
      List<String> simulator, int jobs, Consumer<String> weaker, GradingListener listener)
      throws IOException, InterruptedException {
    Path into = request.into().toAbsolutePath();
    Files.createDirectories(into);
    try (TemporaryFolder scratch = TemporaryFolder.create("tello-grade")) {
      List<HandIn> all = handIns(scratch.path());
      List<HandIn> handIns = selected(all);
      Optional<String> obstacle = Confinement.obstacle(scratch.path());
      if (obstacle.isPresent() && assignment.build().isPresent()) {
        throw new IOException("building needs programs to be confined. " + obstacle.get());
      }
      obstacle.ifPresent(
          reason ->
              weaker.accept(
                  "Programs are not confined: they can read and write whatever you can;"
                      + " programs in Python, Node.js and Java find the drone with a shim, others"
                      + " must take its address from TELLO_HOST and TELLO_PORT; and one flies at a"
                      + " time. "
                      + reason));
      GradingPlan plan =
          new GradingPlan(
              assignment,
              request.assignment(),
              courses,
              simulator,
              into,
              scratch.path(),
              hidden(into, scratch.path()),
              obstacle.isEmpty());
      try (Grader started = new Grader(plan, handIns, listener)) {
        grader = Optional.of(started);
        if (closed) {
          grader.ifPresent(Grader::close);
        }
        Grades grades = started.grade(all.size(), obstacle.isPresent() ? 1 : jobs);
        boolean part = request.only().isPresent() || request.shard().of() > 1 || closed;
        Grades whole = part ? withOthers(grades, into) : grades;
        whole.write(into);
        return whole;
      }
    }
  }

  /**
   * Returns the grades together with those of other hand-ins of the same assignment that are in the
   * folder already.
   */
  private static Grades withOthers(Grades grades, Path into) throws IOException {
    if (!Files.exists(into.resolve(Grades.JSON))) {
      return grades;
    }
    Set<String> ours = new HashSet<>();
    grades.handIns().forEach(each -> ours.add(each.folder()));
    Grades before = Grades.read(into);
    if (!before.assignment().equals(grades.assignment())) {
      return grades;
    }
    List<GradedHandIn> others =
        before.handIns().stream().filter(each -> !ours.contains(each.folder())).toList();
    return Grades.merged(List.of(grades, before.with(others)));
  }

  private List<Path> hidden(Path into, Path scratch) {
    Path handIns = request.handIns().toAbsolutePath();
    List<Path> hidden =
        new ArrayList<>(List.of(into, ScenarioFile.folder(request.assignment().toAbsolutePath())));
    hidden.add(Files.isDirectory(handIns) ? handIns : handIns.getParent());
    hidden.add(scratch);
    request.roster().ifPresent(roster -> hidden.add(roster.toAbsolutePath().getParent()));
    for (SeededCourse course : courses) {
      Path file = Path.of(course.scenario());
      if (Files.isRegularFile(file)) {
        hidden.add(file.toAbsolutePath().getParent());
      }
    }
    return hidden;
  }

  private List<HandIn> handIns(Path scratch) throws IOException {
    List<Roster.Student> roster =
        request.roster().isPresent() ? Roster.read(request.roster().get()) : List.of();
    List<HandIn> all = new HandIns(assignment, scratch).collect(request.handIns(), roster);
    if (all.isEmpty()) {
      throw new IOException(
          request.handIns()
              + " contains no hand-ins: expected a folder or a program for each student");
    }
    return all;
  }

  /** Returns the hand-ins that are graded. */
  private List<HandIn> selected(List<HandIn> all) throws IOException {
    List<HandIn> shard =
        IntStream.range(0, all.size())
            .filter(i -> i % request.shard().of() == request.shard().index() - 1)
            .mapToObj(all::get)
            .toList();
    if (request.only().isEmpty()) {
      return shard;
    }
    String name = request.only().get().toLowerCase(Locale.ROOT);
    List<HandIn> only =
        all.stream()
            .filter(
                each ->
                    Stream.of(each.name(), each.folder(), each.id())
                        .anyMatch(word -> word.toLowerCase(Locale.ROOT).equals(name)))
            .toList();
    if (only.isEmpty()) {
      throw new IOException("there is no hand-in " + request.only().get());
    }
    return only;
  }

  /**
   * Merges the results of parts of a class.
   *
   * @throws IOException if a folder cannot be read or written, or they belong to different
   *     assignments; the message is a clause
   */
  public static Grades merge(List<Path> parts, Path into) throws IOException {
    List<Grades> read = new ArrayList<>();
    Set<String> folders = new HashSet<>();
    for (Path part : parts) {
      Grades grades = Grades.read(part);
      read.add(grades);
      for (GradedHandIn handIn : grades.handIns()) {
        if (!folders.add(handIn.folder())) {
          throw new IOException(part + " also contains the hand-in \"" + handIn.folder() + "\"");
        }
      }
      if (!grades.assignment().equals(read.get(0).assignment())) {
        throw new IOException(part + " is of another assignment than " + parts.get(0));
      }
    }
    Files.createDirectories(into);
    for (Path part : parts) {
      copy(part.resolve(Grader.RECORDINGS), into.resolve(Grader.RECORDINGS));
    }
    Grades merged = Grades.merged(read);
    merged.write(into);
    return merged;
  }

  /**
   * Computes all points again from the recordings, and writes the grades. A flight whose recording
   * cannot be read keeps its points.
   *
   * @param unread receives a sentence for each recording that cannot be read
   * @throws IOException if the grades cannot be read or written; the message is a clause
   */
  public static Grades regrade(Path folder, Consumer<String> unread) throws IOException {
    Grades before = Grades.read(folder);
    List<GradedHandIn> handIns = new ArrayList<>();
    try (TemporaryFolder scratch = TemporaryFolder.create("tello-regrade")) {
      for (GradedHandIn handIn : before.handIns()) {
        List<GradedFlight> flights = new ArrayList<>();
        for (GradedFlight flight : handIn.flights()) {
          try {
            flights.add(Regrading.again(flight, folder, scratch.path()));
          } catch (IOException e) {
            Path recording = folder.resolve(flight.recording());
            unread.accept(
                recording
                    + " cannot be replayed, so its points stay as they were: "
                    + IoReason.ofReading(e)
                    + ".");
            flights.add(flight);
          }
        }
        handIns.add(handIn.with(flights, before.take(), before.scale()));
      }
    }
    Grades again = before.with(handIns);
    again.write(folder);
    return again;
  }

  private static void copy(Path from, Path to) throws IOException {
    if (!Files.exists(from) || (Files.exists(to) && Files.isSameFile(from, to))) {
      return;
    }
    try (Stream<Path> all = Files.walk(from)) {
      for (Path each : all.toList()) {
        Path target = to.resolve(from.relativize(each).toString());
        if (Files.isDirectory(each)) {
          Files.createDirectories(target);
        } else {
          Files.copy(each, target, StandardCopyOption.REPLACE_EXISTING);
        }
      }
    }
  }

  /** Ends all flights; the grades then contain those that are over. */
  @Override
  public void close() {
    closed = true;
    grader.ifPresent(Grader::close);
  }
}
