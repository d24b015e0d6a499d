package tellosimulator.grade;

import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.DigestOutputStream;
import java.security.MessageDigest;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Queue;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.CountDownLatch;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import tellosimulator.concurrent.ErrorPolicy;
import tellosimulator.concurrent.Worker;
import tellosimulator.files.AtomicFile;
import tellosimulator.files.IoReason;
import tellosimulator.files.Sha256;
import tellosimulator.files.TemporaryFolder;
import tellosimulator.json.Json;
import tellosimulator.json.JsonRecords;
import tellosimulator.launcher.ConfinedBuild;
import tellosimulator.launcher.UnavailableException;
import tellosimulator.scenario.Assignment;
import tellosimulator.time.RealTimer;
import tellosimulator.words.Phrase;

/**
 * Flies all hand-ins on all courses, several at once, each job on a thread of its own. A flight
 * whose result is there already, from the same files, is not repeated. {@link #close} is
 * thread-safe; all other methods are called on one thread.
 */
final class Grader implements AutoCloseable {

  static final String RECORDINGS = "recordings";

  /** The file that contains the result of a flight once it is over. */
  private static final String KEPT = "flight.json";

  private final GradingPlan plan;
  private final List<HandIn> handIns;
  private final GradingListener listener;
  private final Queue<Task> tasks = new ConcurrentLinkedQueue<>();
  private final Map<Task, GradedFlight> done = new ConcurrentHashMap<>();
  private final Map<String, Optional<Path>> builds = new ConcurrentHashMap<>();
  private final Set<HandInFlight> flying = ConcurrentHashMap.newKeySet();
  private volatile boolean closed;
  private volatile Optional<String> failure = Optional.empty();

  /** A flight to be flown. */
  private record Task(HandIn handIn, SeededCourse course, int attempt, String fingerprint) {

    /** Returns its folder, relative to that of the results. */
    String place() {
      String name = GradedFlight.name(course.name(), course.seed(), attempt);
      return RECORDINGS + "/" + handIn.folder() + "/" + name;
    }
  }

  Grader(GradingPlan plan, List<HandIn> handIns, GradingListener listener) {
    this.plan = plan;
    this.handIns = List.copyOf(handIns);
    this.listener = listener;
  }

  /**
   * Flies everything that has no result yet.
   *
   * @param all the number of hand-ins of the class
   * @param jobs the number of flights at a time
   * @return the grades; if this was closed, those of the hand-ins whose flights are all over
   * @throws IOException if a file cannot be read or written; the message is a clause
   */
  Grades grade(int all, int jobs) throws IOException, InterruptedException {
    List<Task> flights = tasks();
    tasks.addAll(flights);
    listener.begins(flights.size());
    CountDownLatch running = new CountDownLatch(jobs);
    for (int i = 1; i <= jobs; i++) {
      Worker.once("grade-" + i, ErrorPolicy.finish("A flight was not graded"), () -> work(running));
    }
    running.await();
    if (failure.isPresent()) {
      throw new IOException(failure.get());
    }
    List<GradedHandIn> graded = new ArrayList<>();
    Assignment assignment = plan.assignment();
    for (HandIn handIn : handIns) {
      List<GradedFlight> own =
          flights.stream()
              .filter(task -> task.handIn().equals(handIn) && done.containsKey(task))
              .map(done::get)
              .toList();
      if (own.size() == plan.courses().size() * assignment.attempts()) {
        graded.add(GradedHandIn.of(handIn, own, assignment.take(), assignment.scale()));
      }
    }
    Map<String, String> titles =
        plan.courses().stream()
            .collect(Collectors.toMap(SeededCourse::name, SeededCourse::title, (one, two) -> one));
    return new Grades(
        assignment.name(), assignment.take(), assignment.scale(), all, titles, graded);
  }

  private List<Task> tasks() throws IOException {
    List<Task> all = new ArrayList<>();
    byte[] assignment = Files.readAllBytes(plan.file());
    for (HandIn handIn : handIns) {
      MessageDigest files = Sha256.create();
      files.update(assignment);
      files.update(
          (handIn.file() + handIn.problem().map(Phrase::english)).getBytes(StandardCharsets.UTF_8));
      for (Path file : handIn.problem().isEmpty() ? tree(handIn.files()) : List.<Path>of()) {
        if (Files.isRegularFile(file)) {
          files.update(handIn.files().relativize(file).toString().getBytes(StandardCharsets.UTF_8));
          try (OutputStream into = new DigestOutputStream(OutputStream.nullOutputStream(), files)) {
            Files.copy(file, into);
          }
        }
      }
      byte[] ofHandIn = files.digest();
      for (SeededCourse course : plan.courses()) {
        MessageDigest both = Sha256.create();
        both.update(ofHandIn);
        both.update(course.fingerprint().getBytes(StandardCharsets.UTF_8));
        String fingerprint = HexFormat.of().formatHex(both.digest());
        for (int i = 1; i <= plan.assignment().attempts(); i++) {
          all.add(new Task(handIn, course, i, fingerprint));
        }
      }
    }
    return all;
  }

  private void work(CountDownLatch running) {
    try {
      for (Task task = tasks.poll(); task != null && !closed; task = tasks.poll()) {
        Optional<GradedFlight> kept = kept(folder(task), task.fingerprint());
        GradedFlight flight = kept.isPresent() ? kept.get() : fly(task);
        done.put(task, flight);
        listener.graded(task.handIn().name(), flight, kept.isPresent());
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt(); // closed
    } catch (IOException | UncheckedIOException | UnavailableException e) {
      fail(e.getMessage());
    } finally {
      running.countDown();
    }
  }

  private void fail(String reason) {
    if (!closed) {
      failure = Optional.of(String.valueOf(reason));
      close();
    }
  }

  private GradedFlight fly(Task task)
      throws IOException, UnavailableException, InterruptedException {
    SeededCourse course = task.course();
    Path folder = folder(task);
    clear(folder);
    RealTimer watch = new RealTimer();
    HandInFlight.Outcome outcome;
    try {
      outcome = outcome(task, folder);
    } catch (UncheckedIOException e) {
      outcome = failed(course, e.getCause());
    } catch (IOException e) {
      outcome = failed(course, e);
    }
    double wall = Math.round(watch.seconds() * 10) / 10.0;
    boolean recorded = Files.exists(folder.resolve(HandInFlight.RECORDING));
    GradedFlight flight =
        new GradedFlight(
            course.name(),
            course.seed(),
            task.attempt(),
            outcome.result(),
            outcome.program(),
            outcome.time(),
            wall,
            recorded ? task.place() + "/" + HandInFlight.RECORDING : "",
            outcome.problem());
    if (flight.failed()) {
      return flight; // is flown again the next time
    }
    String json =
        Json.text(
            Json.object(
                "fingerprint",
                task.fingerprint(),
                "flight",
                JsonRecords.write(GradedFlight.class, flight)));
    AtomicFile.write(folder.resolve(KEPT), out -> out.write(json.getBytes(StandardCharsets.UTF_8)));
    return flight;
  }

  private Path folder(Task task) {
    return plan.into().resolve(task.place());
  }

  private static Optional<GradedFlight> kept(Path folder, String fingerprint) throws IOException {
    Path file = folder.resolve(KEPT);
    if (!Files.exists(file)) {
      return Optional.empty();
    }
    try {
      return Json.value(Files.readString(file)) instanceof Map<?, ?> kept
              && fingerprint.equals(kept.get("fingerprint"))
          ? Optional.of(JsonRecords.read(GradedFlight.class, kept.get("flight")))
          : Optional.empty();
    } catch (IllegalArgumentException e) {
      return Optional.empty(); // of another version
    }
  }

  /** Returns the outcome of a flight that could not be flown, which concerns no other flight. */
  private HandInFlight.Outcome failed(SeededCourse course, IOException e)
      throws InterruptedException {
    if (closed) {
      throw new InterruptedException();
    }
    Phrase reason =
        Phrase.of("The flight could not be graded: %s.", String.valueOf(IoReason.of(e)));
    return new HandInFlight.Outcome(
        course.unflown(), GradedFlight.SIMULATOR_FAILED, "", Optional.of(reason));
  }

  private HandInFlight.Outcome outcome(Task task, Path folder)
      throws IOException, UnavailableException, InterruptedException {
    HandIn handIn = task.handIn();
    if (handIn.problem().isPresent() || handIn.file().isEmpty()) {
      Optional<Phrase> why = handIn.problem().filter(each -> !handIn.original().isEmpty());
      return new HandInFlight.Outcome(task.course().unflown(), handIn.obstacle(), "", why);
    }
    Optional<Path> files = built(handIn, folder);
    if (closed) {
      throw new InterruptedException();
    }
    if (files.isEmpty()) {
      return new HandInFlight.Outcome(task.course().unflown(), "did not build", "");
    }
    Path stash = Files.createTempDirectory(plan.scratch(), "stash");
    HandInFlight flight = new HandInFlight(plan, task.course(), folder);
    flying.add(flight);
    try (flight) {
      if (closed) {
        throw new InterruptedException();
      }
      return flight.fly(files.get(), handIn.file(), stash);
    } finally {
      flying.remove(flight);
      Files.deleteIfExists(stash);
    }
  }

  /** Returns the files to fly; empty if they cannot be built. */
  private Optional<Path> built(HandIn handIn, Path folder) throws IOException {
    Optional<List<String>> command = Commands.build(plan.assignment(), handIn.file());
    if (command.isEmpty()) {
      return Optional.of(handIn.files());
    }
    synchronized (handIn) { // other flights of it wait for the first one
      if (!builds.containsKey(handIn.folder())) {
        builds.put(handIn.folder(), build(handIn, command.get(), folder));
      }
      return builds.get(handIn.folder());
    }
  }

  private Optional<Path> build(HandIn handIn, List<String> command, Path folder) {
    try {
      Path archive = Files.createTempFile(plan.scratch(), "built", ".tar");
      Path stash = Files.createTempDirectory(plan.scratch(), "stash");
      ConfinedBuild building = new ConfinedBuild(() -> closed);
      Optional<Integer> code =
          building.run(
              plan.confinement(handIn.files(), stash),
              command,
              archive,
              folder.resolveSibling(GradedFlight.BUILD_OUTPUT));
      return code.filter(each -> each == 0).map(each -> archive);
    } catch (UnavailableException e) {
      throw new UncheckedIOException(new IOException(e.getMessage(), e));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return Optional.empty();
    }
  }

  private static List<Path> tree(Path folder) throws IOException {
    try (Stream<Path> all = Files.walk(folder)) {
      return all.sorted().toList();
    }
  }

  /** Makes an empty folder. */
  static void clear(Path folder) throws IOException {
    if (Files.exists(folder)) {
      TemporaryFolder.deleteAll(folder);
    }
    Files.createDirectories(folder);
  }

  /** Ends all flights; those that are over are kept. */
  @Override
  public void close() {
    closed = true;
    flying.forEach(HandInFlight::close);
  }
}
