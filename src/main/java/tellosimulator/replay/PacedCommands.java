package tellosimulator.replay;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.TreeMap;
import java.util.stream.IntStream;
import tellosimulator.command.CommandSyntax;
import tellosimulator.command.Peer;
import tellosimulator.command.WireText;
import tellosimulator.protocol.app.NamedPacket;
import tellosimulator.protocol.app.VideoPort;
import tellosimulator.recording.RecordedCommand;
import tellosimulator.recording.RecordedCommand.Outcome;
import tellosimulator.recording.RecordedInputs.RecordedInput;
import tellosimulator.sim.Control;
import tellosimulator.sim.SimEvent;
import tellosimulator.sim.SimInput;
import tellosimulator.time.SimTime;

/**
 * Sends the commands of a recording that does not contain all inputs, such as a recording of a real
 * drone. Drones that were just switched on receive the commands with the timing of the recorded
 * program. A command that followed a reply is sent with the same delay after the simulated reply.
 * Any other command is sent with the same delay after the previous command. Thus, a drone that
 * takes longer than the recorded one does not receive the next command too early. Called on the
 * thread that steps the simulation.
 */
final class PacedCommands implements Inputs {

  /**
   * How much longer a simulated reply may take than the recorded reply [s]. The flight also
   * continues for this long after the last command and the last reply. Decided: longer than any
   * move.
   */
  private static final double PATIENCE = 20;

  /** Connects in the app's protocol, with the video for port 6038. */
  private static final String APP_GREETING = "conn_req:\u0096\u0017";

  private static final Peer PROGRAM =
      new Peer(
          new InetSocketAddress(InetAddress.getLoopbackAddress(), 50_000),
          new InetSocketAddress(InetAddress.getLoopbackAddress(), 8889));

  /**
   * A command to be sent.
   *
   * @param awaited the index of the command whose reply preceded this command; empty if another
   *     command preceded it
   * @param gap the delay after that reply or command [s]
   * @param patience the maximum delay after the previous command [s]
   */
  private record Step(String text, OptionalInt awaited, double gap, double patience) {

    /** Whether it belongs to the app's protocol, in which only the time tells what comes next. */
    private boolean ofApp() {
      return PacedCommands.ofApp(text);
    }
  }

  /** The commands for one drone, and a record of which have been sent and answered. */
  private static final class Program {
    private final List<Step> steps = new ArrayList<>();

    /** Indexes of commands that were sent but have not yet arrived at the drone. */
    private final Deque<Integer> sent = new ArrayDeque<>();

    /** Indexes of the commands that arrived, by the number that the drone gave to the command. */
    private final Map<Integer, Integer> taken = new HashMap<>();

    /** Times at which commands were answered [s], by command index. */
    private final Map<Integer, Double> answered = new HashMap<>();

    private int next;
    private double lastSent;

    private boolean due(double now) {
      Step step = steps.get(next);
      if (now - lastSent >= step.patience) {
        return true;
      }
      double from =
          step.awaited.isEmpty()
              ? lastSent
              : answered.getOrDefault(step.awaited.getAsInt(), Double.POSITIVE_INFINITY);
      return now >= from + step.gap;
    }
  }

  private final Map<Integer, Program> programs = new TreeMap<>();
  private final Deque<SimInput> first = new ArrayDeque<>();
  private double lastActivity;

  /**
   * Schedules the commands of a recording.
   *
   * @param commands the commands of the recording
   * @param drones the number of drones; commands to drones with higher numbers are skipped
   */
  PacedCommands(List<RecordedCommand> commands, int drones) {
    for (int drone = 1; drone <= drones; drone++) {
      first.add(new SimInput.Act(new Control.Power(drone, true)));
      int number = drone;
      List<RecordedCommand> own =
          commands.stream()
              .filter(command -> command.drone() == number && command.outcome() != Outcome.LOST)
              .filter(command -> !command.text().endsWith(WireText.APP_SUFFIX)) // only its words
              .toList();
      Program program = new Program();
      program.steps.addAll(steps(own));
      programs.put(drone, program);
    }
  }

  private static boolean ofApp(String text) {
    return NamedPacket.of(WireText.encode(text)).isPresent();
  }

  private static List<Step> steps(List<RecordedCommand> commands) {
    List<Step> steps = new ArrayList<>();
    String first = commands.isEmpty() ? "" : commands.get(0).text();
    String greeting = ofApp(first) ? APP_GREETING : CommandSyntax.COMMAND.verb();
    if (!first.isEmpty()
        && VideoPort.of(WireText.encode(first)).isEmpty()
        && !first.strip().equals(greeting)) {
      steps.add(new Step(greeting, OptionalInt.empty(), 0, PATIENCE)); // sent before this recording
    }
    int offset = steps.size();
    List<Integer> replies =
        IntStream.range(0, commands.size())
            .filter(i -> commands.get(i).answered().isPresent())
            .boxed()
            .sorted(Comparator.comparingDouble(i -> commands.get(i).answered().getAsDouble()))
            .toList();
    int heard = 0;
    double before = commands.isEmpty() ? 0 : commands.get(0).sent();
    for (int i = 0; i < commands.size(); i++) {
      RecordedCommand command = commands.get(i);
      while (heard < replies.size()
          && replies.get(heard) < i
          && reply(commands, replies, heard) <= command.sent()) {
        heard++;
      }
      double reply = heard == 0 ? -1 : reply(commands, replies, heard - 1);
      double gap = command.sent() - before;
      boolean follows = heard > 0 && reply >= before && !ofApp(command.text());
      steps.add(
          new Step(
              command.text(),
              follows ? OptionalInt.of(replies.get(heard - 1) + offset) : OptionalInt.empty(),
              follows ? command.sent() - reply : gap,
              gap + PATIENCE));
      before = command.sent();
    }
    return steps;
  }

  /**
   * Returns the time of a reply [s].
   *
   * @param replies the indexes of the answered commands, in order of their replies
   * @param place the position in that order
   */
  private static double reply(List<RecordedCommand> commands, List<Integer> replies, int place) {
    return commands.get(replies.get(place)).answered().getAsDouble();
  }

  @Override
  public Optional<RecordedInput> due(SimTime now) {
    if (!first.isEmpty()) {
      return Optional.of(new RecordedInput(now, first.removeFirst()));
    }
    for (Map.Entry<Integer, Program> entry : programs.entrySet()) {
      Program program = entry.getValue();
      if (program.next < program.steps.size() && program.due(now.seconds())) {
        Step step = program.steps.get(program.next);
        if (!step.ofApp()) {
          program.sent.addLast(program.next);
        }
        program.next++;
        program.lastSent = now.seconds();
        lastActivity = now.seconds();
        byte[] bytes = WireText.encode(step.text);
        return Optional.of(
            new RecordedInput(now, new SimInput.Datagram(entry.getKey(), PROGRAM, bytes)));
      }
    }
    return Optional.empty();
  }

  @Override
  public boolean goesOn(SimTime now) {
    return now.seconds() < lastActivity + PATIENCE
        || programs.values().stream().anyMatch(program -> program.next < program.steps.size());
  }

  @Override
  public void event(SimEvent event) {
    if (event instanceof SimEvent.FromPeer about && !about.text().endsWith(WireText.APP_SUFFIX)) {
      Program program = programs.get(about.drone());
      if (about instanceof SimEvent.CommandReceived received) {
        // a link that duplicates datagrams can deliver a command that was not sent
        Optional.ofNullable(program.sent.pollFirst())
            .ifPresent(index -> program.taken.put(received.request().number(), index));
      } else if (about instanceof SimEvent.OfCommand answer) {
        lastActivity = event.time().seconds();
        Optional.ofNullable(program.taken.get(answer.request().number()))
            .ifPresent(index -> program.answered.putIfAbsent(index, lastActivity));
      } else if (about instanceof SimEvent.CommandIgnored
          || about instanceof SimEvent.CommandLost) {
        program.sent.pollFirst();
      }
    }
  }
}
