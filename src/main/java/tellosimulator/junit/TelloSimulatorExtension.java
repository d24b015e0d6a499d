package tellosimulator.junit;

import java.lang.reflect.AnnotatedElement;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.Semaphore;
import org.junit.jupiter.api.extension.AfterAllCallback;
import org.junit.jupiter.api.extension.AfterEachCallback;
import org.junit.jupiter.api.extension.AfterTestExecutionCallback;
import org.junit.jupiter.api.extension.BeforeAllCallback;
import org.junit.jupiter.api.extension.BeforeEachCallback;
import org.junit.jupiter.api.extension.ExtensionContext;
import org.junit.jupiter.api.extension.ExtensionContext.Namespace;
import org.junit.jupiter.api.extension.MediaType;
import org.junit.jupiter.api.extension.ParameterContext;
import org.junit.jupiter.api.extension.ParameterResolutionException;
import org.junit.jupiter.api.extension.ParameterResolver;
import org.junit.jupiter.api.extension.TestExecutionExceptionHandler;
import org.junit.platform.commons.JUnitException;
import org.junit.platform.commons.support.AnnotationSupport;
import org.opentest4j.AssertionFailedError;
import org.opentest4j.IncompleteExecutionException;
import tellosimulator.recording.FlightRecorder;
import tellosimulator.recording.RecordedFlight;
import tellosimulator.recording.RecordingFolder;
import tellosimulator.report.FlightReport;
import tellosimulator.report.ReportTexts;
import tellosimulator.translation.PhraseCatalog;

/**
 * Provides simulated drones to JUnit tests. The {@link TelloTest} annotation registers this
 * extension. Alternatively, a builder configures it for a field with {@code RegisterExtension}: a
 * static field provides one simulator per class, an instance field one per test. Called by JUnit.
 */
public final class TelloSimulatorExtension
    implements BeforeAllCallback,
        AfterAllCallback,
        BeforeEachCallback,
        AfterEachCallback,
        AfterTestExecutionCallback,
        TestExecutionExceptionHandler,
        ParameterResolver {

  /** Name of the file that is published when a test fails. */
  private static final String PUBLISHED = "tello-flight.txt";

  /** Name of the folder of recordings that is published when a test fails. */
  private static final String RECORDINGS = "tello-recordings";

  /** Base name of the published flight reports, without the number and the extension. */
  private static final String REPORT = "tello-flight";

  private static final MediaType HTML = MediaType.create("text", "html", StandardCharsets.UTF_8);

  private final Optional<Builder> configured;
  private final Namespace namespace;

  /** The settings of the simulator, and whether a crash fails the test. */
  public static final class Builder extends SimulatorSettings<Builder> {

    private OnCrash onCrash = OnCrash.FAIL;

    private Builder() {}

    @Override
    Builder self() {
      return this;
    }

    /**
     * Sets whether a test fails if it passes its own assertions, but a drone crashed or the goals
     * were missed. By default, the test fails.
     */
    public Builder onCrash(OnCrash what) {
      onCrash = what;
      return this;
    }

    /** Returns the extension, for a field annotated with {@code RegisterExtension}. */
    public TelloSimulatorExtension build() {
      return new TelloSimulatorExtension(Optional.of(this));
    }
  }

  /**
   * A simulator in use by tests.
   *
   * @param owner the id of the context at whose end the simulator is closed
   * @param turn the permit that a test holds while it runs, so that tests run one after another
   */
  private record Running(TelloSimulator simulator, OnCrash onCrash, String owner, Semaphore turn) {}

  /** Creates an extension for {@link TelloTest}. Called by JUnit. */
  public TelloSimulatorExtension() {
    this(Optional.empty());
  }

  private TelloSimulatorExtension(Optional<Builder> configured) {
    this.configured = configured;
    this.namespace =
        configured.isPresent()
            ? Namespace.create(TelloSimulatorExtension.class, this)
            : Namespace.create(TelloSimulatorExtension.class);
  }

  /** Returns a builder with default settings. */
  public static Builder builder() {
    return new Builder();
  }

  @Override
  public void beforeAll(ExtensionContext context) {
    Class<?> type = context.getRequiredTestClass();
    boolean own = configured.isEmpty() && AnnotationSupport.isAnnotated(type, TelloTest.class);
    if (own || running(context).isEmpty()) {
      start(context, type);
    }
  }

  @Override
  public void afterAll(ExtensionContext context) {
    close(context);
  }

  @Override
  public void beforeEach(ExtensionContext context) {
    boolean own =
        configured.isEmpty()
            && AnnotationSupport.isAnnotated(context.getRequiredTestMethod(), TelloTest.class);
    if (own || running(context).isEmpty()) {
      start(context, own ? context.getRequiredTestMethod() : context.getRequiredTestClass());
    }
    Running running = running(context).orElseThrow();
    running.turn.acquireUninterruptibly();
    context.getStore(namespace).put(Semaphore.class, running.turn);
    if (running.simulator.closed()) {
      throw new IllegalStateException(
          "a test before "
              + context.getDisplayName()
              + " closed the simulator that all tests of the class share; a parameter must not be"
              + " closed");
    }
    running.simulator.reset();
    running.simulator.recorder().forget();
  }

  @Override
  public void afterEach(ExtensionContext context) {
    Semaphore turn = context.getStore(namespace).remove(Semaphore.class, Semaphore.class);
    if (turn != null) {
      turn.release();
    }
    close(context);
  }

  private void start(ExtensionContext context, AnnotatedElement element) {
    Builder settings = configured.orElseGet(() -> settings(context, element));
    try {
      TelloSimulator simulator = new TelloSimulator(settings);
      simulator.remember();
      context
          .getStore(namespace)
          .put(
              Running.class,
              new Running(simulator, settings.onCrash, context.getUniqueId(), new Semaphore(1)));
    } catch (IllegalArgumentException e) {
      throw new IllegalArgumentException(
          (configured.isPresent() ? "TelloSimulatorExtension" : "@TelloTest")
              + " of "
              + element
              + ": "
              + e.getMessage(),
          e);
    }
  }

  private static Builder settings(ExtensionContext context, AnnotatedElement element) {
    TelloTest said =
        AnnotationSupport.findAnnotation(element, TelloTest.class)
            .or(
                () ->
                    AnnotationSupport.findAnnotation(
                        context.getRequiredTestClass(),
                        TelloTest.class,
                        context.getEnclosingTestClasses()))
            .orElseThrow(
                () ->
                    new IllegalArgumentException(
                        "the extension is registered by @ExtendWith, but needs @TelloTest"));
    Builder builder =
        builder()
            .scenario(said.scenario())
            .profile(said.profile())
            .behavior(said.behavior())
            .timeFactor(said.timeFactor())
            .link(said.link())
            .video(said.video())
            .ports(said.ports())
            .onCrash(said.onCrash());
    List.of(said.faults()).forEach(builder::fault);
    if (said.drones() != 0) {
      builder.drones(said.drones());
    }
    if (said.seed() != 0) {
      builder.seed(said.seed());
    }
    return builder;
  }

  private Optional<Running> running(ExtensionContext context) {
    return Optional.ofNullable(context.getStore(namespace).get(Running.class, Running.class));
  }

  private void close(ExtensionContext context) {
    Optional<Running> running =
        running(context).filter(one -> one.owner.equals(context.getUniqueId()));
    if (running.isPresent()) {
      context.getStore(namespace).remove(Running.class);
      running.get().simulator.closeOnce();
    }
  }

  // --- failures ---

  @Override
  public void afterTestExecution(ExtensionContext context) throws Exception {
    Optional<Running> running = running(context);
    if (context.getExecutionException().isPresent() || running.isEmpty()) {
      return;
    }
    TelloSimulator simulator = running.get().simulator;
    List<OperatorProgram> unstarted = simulator.unstarted();
    if (!unstarted.isEmpty()) {
      throw new AssertionFailedError(
          "the program " + unstarted.get(0) + " was never run: call run() or exitCode() of it");
    }
    if (running.get().onCrash == OnCrash.ALLOW) {
      return;
    }
    simulator.awaitFalls();
    List<String> unasked = new ArrayList<>();
    for (SimulatedDrone drone : simulator.drones()) {
      drone.truth().touched().stream()
          .filter(DroneTruth.Touch::crash)
          .map(touch -> drone + " " + FlightExplanation.touch(touch))
          .forEach(unasked::add);
    }
    if (unasked.isEmpty() && simulator.simulation().goals().missed()) {
      unasked.add("the goals were missed");
    }
    if (!unasked.isEmpty()) {
      String message = String.join(", ", unasked) + "; onCrash = ALLOW would let that pass";
      throw explained(context, simulator, new AssertionFailedError(message));
    }
  }

  @Override
  public void handleTestExecutionException(ExtensionContext context, Throwable failure)
      throws Throwable {
    Optional<Running> running = running(context);
    if (running.isEmpty() || failure instanceof IncompleteExecutionException) {
      throw failure;
    }
    if (failure instanceof AssertionError error) {
      throw explained(context, running.get().simulator, error);
    }
    failure.addSuppressed(
        new TelloSimulator.FlightFailure(
            "what happened until then", explained(context, running.get().simulator)));
    throw failure;
  }

  private static AssertionError explained(
      ExtensionContext context, TelloSimulator simulator, AssertionError error) {
    String explanation = explained(context, simulator);
    if (error instanceof TelloSimulator.FlightFailure) {
      return error; // already contains the explanation
    }
    String message = error.getMessage() + System.lineSeparator() + explanation;
    AssertionFailedError all =
        error instanceof AssertionFailedError failed && failed.isExpectedDefined()
            ? new AssertionFailedError(message, failed.getExpected(), failed.getActual(), error)
            : new AssertionFailedError(message, error);
    all.setStackTrace(error.getStackTrace());
    return all;
  }

  /**
   * Returns an explanation of what happened, and publishes it as a file, together with recordings
   * and reports.
   */
  private static String explained(ExtensionContext context, TelloSimulator simulator) {
    String explanation = simulator.explanation();
    String text = context.getDisplayName() + System.lineSeparator() + explanation;
    try {
      context.publishFile(
          PUBLISHED,
          MediaType.TEXT_PLAIN_UTF_8,
          file -> Files.writeString(file, text, StandardCharsets.UTF_8));
      if (simulator.recorder().hasFlown()) {
        publishFlights(context, simulator.recorder());
      }
      return explanation;
    } catch (JUnitException e) { // must not hide the cause of the failure
      return explanation + System.lineSeparator() + e.getMessage();
    }
  }

  /**
   * Publishes the recordings of all flights of a test, with a report of each flight in the system's
   * language.
   */
  private static void publishFlights(ExtensionContext context, FlightRecorder recorder) {
    List<Path> recordings = new ArrayList<>();
    context.publishDirectory(
        RECORDINGS,
        path -> {
          RecordingFolder folder = RecordingFolder.at(path);
          recorder.writeTo(folder, reason -> {});
          recordings.addAll(folder.made());
        });
    for (int i = 0; i < recordings.size(); i++) {
      Path recording = recordings.get(i);
      String name = i == 0 ? REPORT + ".html" : REPORT + "-" + (i + 1) + ".html";
      context.publishFile(
          name,
          HTML,
          file ->
              new FlightReport(
                      RecordedFlight.read(recording),
                      new ReportTexts(PhraseCatalog.of(Locale.getDefault())))
                  .write(file));
    }
  }

  // --- parameters ---

  @Override
  public boolean supportsParameter(ParameterContext parameter, ExtensionContext context) {
    Class<?> type = parameter.getParameter().getType();
    return type == SimulatedDrone.class
        || type == TelloSimulation.class
        || type == TelloSimulator.class;
  }

  @Override
  public Object resolveParameter(ParameterContext parameter, ExtensionContext context) {
    Class<?> type = parameter.getParameter().getType();
    TelloSimulator simulator =
        running(context)
            .orElseThrow(
                () ->
                    new ParameterResolutionException(
                        "there is no simulator yet in "
                            + parameter.getDeclaringExecutable().getName()
                            + ": it is started before each test"))
            .simulator;
    if (type == TelloSimulator.class) {
      return simulator;
    }
    if (type == TelloSimulation.class) {
      return simulator.simulation();
    }
    int number = parameter.findAnnotation(Drone.class).map(Drone::value).orElse(1);
    try {
      return simulator.drone(number);
    } catch (IllegalArgumentException e) {
      throw new ParameterResolutionException(
          "@Drone("
              + number
              + ") in "
              + parameter.getDeclaringExecutable().getName()
              + ": "
              + e.getMessage(),
          e);
    }
  }
}
