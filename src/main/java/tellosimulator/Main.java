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
import picocli.CommandLine.IVersionProvider;
import tellosimulator.cli.EscapingPrintStream;
import tellosimulator.cli.ExitCode;
import tellosimulator.cli.Invocation;
import tellosimulator.cli.Invocation.Action;
import tellosimulator.cli.Launch;
import tellosimulator.cli.Options;
import tellosimulator.cli.ProgramInput;
import tellosimulator.cli.ProgramOutput;
import tellosimulator.cli.ScenarioOptions;
import tellosimulator.cli.Subcommand;
import tellosimulator.cli.SubcommandName;
import tellosimulator.concurrent.FatalExit;
import tellosimulator.files.IoReason;
import tellosimulator.goal.Progress.Status;
import tellosimulator.headless.HeadlessSimulator;
import tellosimulator.log.LogSetup;
import tellosimulator.log.StandardErrorLog;
import tellosimulator.memory.ProcessMemory;
import tellosimulator.network.PortTakenException;
import tellosimulator.recording.RecordingFolder;
import tellosimulator.recording.UnreadableRecordingException;
import tellosimulator.report.FlightReports;
import tellosimulator.report.ReportTexts;
import tellosimulator.video.SoftwareCameras;
import tellosimulator.view.app.ReplayApp;
import tellosimulator.view.app.SimulatorApp;
import tellosimulator.view.app.Toolkit;
import tellosimulator.view.app.ToolkitFailure;
import tellosimulator.view.layout.WindowState;
import tellosimulator.view.replay.ReplayFlight;
import tellosimulator.view.settings.DataFolder;
import tellosimulator.view.settings.Settings;
import tellosimulator.view.text.Language;

/** The command line: reads the options, then runs the simulator or a {@link Subcommand}. */
public final class Main {

  /** Flights of the window that are kept. Decided: those of a lesson. */
  private static final int RECORDINGS_KEPT = 20;

  private final Options options = new Options();
  private final PrintStream out;
  private final PrintStream err;
  private final ProgramOutput output;

  private Main(PrintStream out, PrintStream err) {
    this.out = new EscapingPrintStream(out);
    this.err = new EscapingPrintStream(err);
    ProgramInput input = new ProgramInput(System.in, Main::atEnd);
    output = new ProgramOutput(this.out, this.err, out, () -> language().translation(), input);
  }

  /** Ends the process with an {@link ExitCode}, or that of {@link FatalExit}. */
  public static void main(String[] args) {
    System.setProperty("java.awt.headless", "true"); // posters are read, nothing is drawn
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

  /** What is done when the program is told to end, as by Ctrl-C. */
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
          .run(ScenarioOptions.withFileNamed(args), () -> action(List.of(args)));
    }
    Subcommand subcommand = name.get().subcommand();
    return new Invocation(subcommand.commandLine(new Version()), List.of(), output)
        .run(Arrays.copyOfRange(args, 1, args.length), () -> subcommand.action(output));
  }

  /** That of the window. */
  private static Language language() {
    Language language = new Language(Locale.getDefault());
    Settings.load(Settings.file()).bind("language", language.localeProperty(), Language.codec());
    return language;
  }

  /** What the options ask for. */
  private Action action(List<String> words) {
    if (options.listScenarios()) {
      return this::listScenarios;
    }
    LogSetup.setLevel(options.logLevel());
    options.checkReplay();
    if (options.replay().isPresent()) {
      return () -> replay(options.replay().get());
    }
    Launch launch = options.launch();
    return () -> simulate(launch, words);
  }

  private int listScenarios() {
    ScenarioOptions.list(out, output.translation().get().locale());
    return ExitCode.DONE;
  }

  /**
   * What a window needs.
   *
   * @param obstacle why there can be none
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

  private int simulate(Launch launch, List<String> words)
      throws PortTakenException, InterruptedException {
    if (options.headless()) {
      return simulateHeadless(launch, words);
    }
    WindowStart window = WindowStart.attempt();
    if (window.obstacle().isPresent()) {
      err.println(window.obstacle().get().sentence());
      return simulateHeadless(launch, words);
    }
    return simulateInWindow(launch, window, words);
  }

  private int simulateInWindow(Launch launch, WindowStart window, List<String> words)
      throws InterruptedException, PortTakenException {
    SimulatorApp.Rules rules =
        new SimulatorApp.Rules(
            options::applied, options::addressPlan, options.replyPort(), recordings(words));
    try (SimulatorApp app = new SimulatorApp(launch.scenario(), rules, options.optics())) {
      atEnd(app::close);
      if (options.on()) {
        app.switchAllOn();
        out.println(app.ready());
      }
      if (!options.choosesRoom()) {
        app.beginWithGallery();
      }
      return app.run(window.settings(), window.state()) ? ExitCode.DONE : ExitCode.FAILED;
    }
  }

  /** In the window each flight is recorded, so that one can look at it afterwards. */
  private SimulatorApp.Recordings recordings(List<String> words) {
    RecordingFolder folder =
        options
            .record()
            .map(RecordingFolder::at)
            .orElseGet(() -> RecordingFolder.keeping(DataFolder.recordings(), RECORDINGS_KEPT));
    return new SimulatorApp.Recordings(folder, options.record().isPresent(), words);
  }

  private int simulateHeadless(Launch launch, List<String> words)
      throws PortTakenException, InterruptedException {
    try (HeadlessSimulator simulator =
        new HeadlessSimulator(
            launch.scenario().scenario(),
            launch.addresses(),
            options.replyPort(),
            new SoftwareCameras(options.optics()))) {
      Optional<RecordingFolder> kept = options.record().map(RecordingFolder::at);
      Optional<FlightReports> reports =
          options.report().isPresent()
              ? Optional.of(FlightReports.to(options.report().get(), kept))
              : Optional.empty();
      reports
          .map(FlightReports::recordings)
          .or(() -> kept)
          .ifPresent(folder -> simulator.record(folder, launch.scenario().title(), words));
      simulator.switchOn();
      atEnd(() -> end(simulator, reports));
      if (options.control().isPresent()) {
        simulator.openControl(options.control().get(), out);
      }
      simulator.sayReady(out);
      int status = run(simulator);
      return end(simulator, reports) || status != ExitCode.DONE ? status : ExitCode.FAILED;
    } catch (PortTakenException e) {
      throw e;
    } catch (IOException e) {
      err.println("There is no place for recordings: " + IoReason.of(e) + ".");
      return ExitCode.FAILED;
    }
  }

  /** Ends all, also when the program is told to end; whether all reports were written. */
  private boolean end(HeadlessSimulator simulator, Optional<FlightReports> reports) {
    simulator.close();
    return reports
        .map(
            each ->
                each.write(
                    () -> new ReportTexts(output.translation().get()),
                    file -> out.println("report: " + file),
                    err::println))
        .orElse(true);
  }

  /** Until it is over; the exit code of the program. */
  private int run(HeadlessSimulator simulator) throws InterruptedException {
    Charset charset = Charset.defaultCharset();
    BufferedReader in = new BufferedReader(new InputStreamReader(System.in, charset));
    if (options.exitWhenDone()) {
      Status status = simulator.runUntilDone(options.timeout(), in, out);
      if (options.awaitsProgram()) {
        simulator.awaitFinish();
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
