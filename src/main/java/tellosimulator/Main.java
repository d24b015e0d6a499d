package tellosimulator;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.nio.charset.Charset;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Supplier;
import picocli.CommandLine.IVersionProvider;
import tellosimulator.cli.EscapingPrintStream;
import tellosimulator.cli.ExitCode;
import tellosimulator.cli.Invocation;
import tellosimulator.cli.Invocation.Action;
import tellosimulator.cli.Options;
import tellosimulator.cli.ProgramInput;
import tellosimulator.cli.ProgramOutput;
import tellosimulator.cli.ScenarioOptions;
import tellosimulator.cli.Subcommand;
import tellosimulator.cli.SubcommandName;
import tellosimulator.concurrent.FatalExit;
import tellosimulator.files.IoReason;
import tellosimulator.files.TemporaryFolder;
import tellosimulator.goal.Progress.Status;
import tellosimulator.goal.Score;
import tellosimulator.headless.HeadlessSimulator;
import tellosimulator.jvm.ProcessMemory;
import tellosimulator.launcher.ProgramRun;
import tellosimulator.log.LogSetup;
import tellosimulator.log.StandardErrorLog;
import tellosimulator.network.PortTakenException;
import tellosimulator.recording.FlightResult;
import tellosimulator.recording.RecordingFolder;
import tellosimulator.recording.UnreadableRecordingException;
import tellosimulator.report.FlightReports;
import tellosimulator.report.ReportTexts;
import tellosimulator.scenario.OpenedScenario;
import tellosimulator.video.SoftwareCameras;
import tellosimulator.view.app.ReplayApp;
import tellosimulator.view.app.SimulatorApp;
import tellosimulator.view.app.Toolkit;
import tellosimulator.view.app.ToolkitFailure;
import tellosimulator.view.layout.WindowState;
import tellosimulator.view.replay.ReplayFlight;
import tellosimulator.view.settings.Settings;
import tellosimulator.view.settings.UserFolder;
import tellosimulator.view.text.Language;
import tellosimulator.web.BoardReporter;

/** The entry point: parses the options, then runs the simulator or a {@link Subcommand}. */
public final class Main {

  /**
   * Maximum number of recordings of flights in the window or from browsers, unless the user has
   * chosen a folder; older ones are deleted. Decided: enough for a lesson.
   */
  private static final int RECORDINGS_KEPT = 20;

  private final Options options = new Options();
  private final PrintStream out;
  private final PrintStream err;
  private final ProgramOutput output;

  /** Reports to the teacher's board, if the options say so. */
  private volatile Optional<BoardReporter> reporter = Optional.empty();

  private boolean scorePrinted;

  /** Whether the result has been written, or need not be. */
  private boolean resultWritten;

  private Main(PrintStream out, PrintStream err) {
    this.out = new EscapingPrintStream(out);
    this.err = new EscapingPrintStream(err);
    ProgramInput input = new ProgramInput(System.in, Main::atEnd);
    output = new ProgramOutput(this.out, this.err, out, () -> language().translation(), input);
  }

  /**
   * Runs the program, then ends the process with an {@link ExitCode} or with the code of {@link
   * FatalExit}.
   */
  public static void main(String[] args) {
    System.setProperty("java.awt.headless", "true"); // AWT only reads image files
    FatalExit fatal = FatalExit.install(LogSetup::flush);
    ProcessMemory.keepSmall();
    int status = FatalExit.CODE;
    try {
      status = run(args, System.out, System.err);
      LogSetup.flush();
    } catch (Throwable failure) {
      fatal.end(Thread.currentThread(), failure);
    }
    System.exit(status);
  }

  /** Registers a task that runs when the program is asked to end, for example by Ctrl-C. */
  private static void atEnd(Runnable task) {
    Runtime.getRuntime().addShutdownHook(new Thread(task, "shutdown"));
  }

  /** Runs the program and returns its exit code. */
  static int run(String[] args, PrintStream out, PrintStream err) {
    return new Main(out, err).run(args);
  }

  private int run(String... args) {
    Optional<SubcommandName> name = SubcommandName.of(args);
    if (name.isEmpty()) {
      return new Invocation(options.commandLine(new Version()), SubcommandName.words(), output)
          .run(ScenarioOptions.spelledOut(args), () -> action(List.of(args)));
    }
    Subcommand subcommand = name.get().subcommand();
    return new Invocation(subcommand.commandLine(new Version()), List.of(), output)
        .run(Arrays.copyOfRange(args, 1, args.length), () -> subcommand.action(output));
  }

  /**
   * Returns the language that the user has chosen in the window, by default the system's language.
   */
  private static Language language() {
    Language language = new Language(Locale.getDefault());
    Settings.load(Settings.file()).bind("language", language.localeProperty(), Language.codec());
    return language;
  }

  /** Returns the action that the options request. */
  private Action action(List<String> words) {
    if (options.listScenarios()) {
      return this::listScenarios;
    }
    LogSetup.setLevel(options.logLevel());
    options.checkReplay();
    if (options.replay().isPresent()) {
      return () -> replay(options.replay().get());
    }
    OpenedScenario first = options.launch();
    return () -> simulate(first, words);
  }

  private int listScenarios() {
    ScenarioOptions.list(out, output.translation().get().locale());
    return ExitCode.DONE;
  }

  /**
   * The settings and the previous state of the window, and whether a window can be opened.
   *
   * @param obstacle the reason why no window can be opened; empty if one can
   */
  private record WindowStart(
      Settings settings, WindowState state, Optional<ToolkitFailure> obstacle) {

    static WindowStart attempt() throws InterruptedException {
      StandardErrorLog.install();
      Settings settings = Settings.load(Settings.file());
      WindowState state = WindowState.remembered(settings);
      state.applyUiScale();
      return new WindowStart(settings, state, Toolkit.start());
    }
  }

  /** Shows recorded flights in the window. */
  private int replay(Path folder) throws UnreadableRecordingException, InterruptedException {
    ReplayFlight flight = ReplayFlight.read(folder);
    Optional<ReplayFlight> ghost = Optional.empty();
    if (options.ghost().isPresent()) {
      ghost = Optional.of(ReplayFlight.read(options.ghost().get()));
    }
    WindowStart window = WindowStart.attempt();
    if (window.obstacle().isPresent()) {
      err.println(
          window.obstacle().get().cause()
              + " The replay needs a window; report FOLDER makes a page of the flight, which any"
              + " browser shows.");
      return ExitCode.FAILED;
    }
    ReplayApp app = new ReplayApp(flight, ghost, options.optics());
    return app.run(window.settings(), window.state()) ? ExitCode.DONE : ExitCode.FAILED;
  }

  private int simulate(OpenedScenario first, List<String> words)
      throws PortTakenException, InterruptedException {
    if (options.headless()) {
      return simulateHeadless(first, words);
    }
    WindowStart window = WindowStart.attempt();
    if (window.obstacle().isPresent()) {
      err.println(window.obstacle().get().sentence());
      return simulateHeadless(first, words);
    }
    return simulateInWindow(first, window, words);
  }

  private int simulateInWindow(OpenedScenario first, WindowStart window, List<String> words)
      throws InterruptedException, PortTakenException {
    SimulatorApp.Rules rules =
        new SimulatorApp.Rules(
            options::applied, options::addressPlan, options.replyPort(), recordings(words));
    try (SimulatorApp app = new SimulatorApp(first, rules, options.optics())) {
      atEnd(() -> end(app));
      if (options.on()) {
        app.switchAllOn();
        out.println(app.ready());
      }
      reporter = options.board().report(app.host());
      if (!options.choosesRoom()) {
        app.beginWithGallery();
      }
      boolean shown = app.run(window.settings(), window.state());
      return end(app) && shown ? ExitCode.DONE : ExitCode.FAILED;
    }
  }

  /** Closes the window's simulator and writes the result; also called when asked to end. */
  private boolean end(SimulatorApp app) {
    reporter.ifPresent(BoardReporter::close);
    app.close();
    return writeResult(app::result);
  }

  /**
   * Writes the result once, if the options ask for it. Returns whether this succeeded.
   *
   * @param result returns the result; its simulator has closed
   */
  private synchronized boolean writeResult(Supplier<FlightResult> result) {
    if (resultWritten || options.result().isEmpty()) {
      return true;
    }
    resultWritten = true;
    Path file = options.result().get();
    try {
      result.get().write(file);
      return true;
    } catch (IOException e) {
      err.println("The result was not written to " + file + ": " + IoReason.of(e) + ".");
      return false;
    }
  }

  /**
   * Returns the settings for recording the flights in the window. All flights are recorded, so that
   * users can view them afterwards.
   */
  private SimulatorApp.Recordings recordings(List<String> words) {
    RecordingFolder folder =
        options
            .record()
            .map(RecordingFolder::at)
            .orElseGet(() -> RecordingFolder.keeping(UserFolder.recordings(), RECORDINGS_KEPT));
    return new SimulatorApp.Recordings(folder, options.record().isPresent(), words);
  }

  private int simulateHeadless(OpenedScenario first, List<String> words)
      throws PortTakenException, InterruptedException {
    try (HeadlessSimulator simulator =
        new HeadlessSimulator(
            first,
            new HeadlessSimulator.Rules(
                options::applied,
                options::addressPlan,
                options.replyPort(),
                new SoftwareCameras(options.optics())))) {
      Optional<RecordingFolder> kept = options.record().map(RecordingFolder::at);
      Optional<FlightReports> reports =
          options.report().isPresent()
              ? Optional.of(FlightReports.to(options.report().get(), kept))
              : Optional.empty();
      Optional<TemporaryFolder> lent = // for the reports on the page
          options.web().isPresent() && kept.isEmpty() && reports.isEmpty()
              ? Optional.of(TemporaryFolder.create("tello-flights"))
              : Optional.empty();
      reports
          .map(FlightReports::recordings)
          .or(() -> kept)
          .or(() -> lent.map(to -> RecordingFolder.keeping(to.path(), RECORDINGS_KEPT)))
          .ifPresent(folder -> simulator.record(folder, words));
      if (options.web().isPresent()) {
        simulator.openWeb(options.web().get(), out);
      }
      simulator.switchOn();
      atEnd(() -> end(simulator, reports, lent));
      if (options.control().isPresent()) {
        simulator.openControl(options.control().get(), out);
      }
      reporter = options.board().report(simulator);
      simulator.sayReady(out);
      int status = run(simulator);
      return end(simulator, reports, lent) || status != ExitCode.DONE ? status : ExitCode.FAILED;
    } catch (PortTakenException e) {
      throw e;
    } catch (IOException e) {
      err.println("There is no place for recordings: " + IoReason.of(e) + ".");
      return ExitCode.FAILED;
    }
  }

  /**
   * Closes the simulator, and writes the result and all reports; also called when the program is
   * asked to end. Returns whether all files were written.
   */
  private boolean end(
      HeadlessSimulator simulator,
      Optional<FlightReports> reports,
      Optional<TemporaryFolder> lent) {
    reporter.ifPresent(BoardReporter::close);
    simulator.close();
    lent.ifPresent(TemporaryFolder::close);
    printScore(simulator);
    boolean written = writeResult(simulator::result);
    return writeReports(reports) && written;
  }

  /** Prints the points of a run that ends by itself, once. */
  private synchronized void printScore(HeadlessSimulator simulator) {
    if (options.exitWhenDone() && !scorePrinted) {
      simulator.score().map(Score::phrase).ifPresent(out::println);
    }
    scorePrinted = true;
  }

  private boolean writeReports(Optional<FlightReports> reports) {
    return reports
        .map(
            each ->
                each.write(
                    () -> new ReportTexts(output.translation().get()),
                    file -> out.println("report: " + file),
                    err::println))
        .orElse(true);
  }

  /** Runs the simulator until it ends; returns the exit code of the program. */
  private int run(HeadlessSimulator simulator) throws InterruptedException {
    Charset charset = Charset.defaultCharset();
    BufferedReader in = new BufferedReader(new InputStreamReader(System.in, charset));
    if (options.exitWhenDone()) {
      if (options.awaitsReplies()) {
        simulator.endUnlessProgramWaits();
      }
      Status status = simulator.runUntilDone(options.timeout(), options.awaitsProgram(), in, out);
      if (options.awaitsReplies() && simulator.programDidNotWait()) {
        return ProgramRun.NOT_WAITING;
      }
      return status == Status.REACHED ? ExitCode.DONE : ExitCode.GOALS_MISSED;
    }
    simulator.run(in, out);
    return ExitCode.DONE;
  }

  private static final class Version implements IVersionProvider {
    @Override
    public String[] getVersion() {
      String version =
          Optional.ofNullable(Main.class.getPackage().getImplementationVersion())
              .orElse("development");
      return new String[] {"Tello Simulator " + version};
    }
  }
}
