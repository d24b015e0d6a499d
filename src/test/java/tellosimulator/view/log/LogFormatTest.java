package tellosimulator.view.log;

import static org.assertj.core.api.Assertions.assertThat;
import static org.mockito.Mockito.mock;
import static org.mockito.Mockito.when;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Test;
import tellosimulator.command.Peer;
import tellosimulator.command.Request;
import tellosimulator.controller.FlightEvent;
import tellosimulator.goal.GoalEvent;
import tellosimulator.network.PortTakenException;
import tellosimulator.sim.SimEvent;
import tellosimulator.time.SimTime;
import tellosimulator.view.text.Language;
import tellosimulator.words.Phrase;

class LogFormatTest {

  private static final Peer PEER =
      new Peer(new InetSocketAddress(9000), new InetSocketAddress(8889));

  private final Language language = new Language(Locale.ENGLISH);
  private final LogFormat alone = new LogFormat(language, false);

  @Test
  void withOneDroneAClauseBecomesASentence() {
    LogLine line = flight(new FlightEvent.TookOff());

    assertThat(alone.words(line)).isEqualTo("The drone took off");
    assertThat(alone.searched(row(line))).isEqualTo("The drone took off");
    assertThat(alone.whole(line)).endsWith("INFO   The drone took off");
    language.localeProperty().set(Locale.GERMAN);
    assertThat(alone.words(line)).isEqualTo("Die Drohne ist gestartet");
  }

  @Test
  void withSeveralDronesTheNumberIsTheSubject() {
    LogFormat several = new LogFormat(language, true);
    LogLine line = flight(new FlightEvent.TookOff());

    assertThat(several.words(line)).isEqualTo("took off");
    assertThat(several.searched(row(line))).isEqualTo("drone 1 took off");
  }

  @Test
  void whatHasASubjectIsASentenceAlready() {
    LogLine command =
        LogLine.of(new SimEvent.CommandReceived(SimTime.ZERO, 1, new Request(1, PEER, "takeoff")));
    LogLine world =
        LogLine.of(new SimEvent.WorldChanged(SimTime.ZERO, Phrase.of("time stands still")));
    LogLine all =
        LogLine.of(
            new GoalEvent.Over(
                SimTime.ZERO, Phrase.of("all goals are reached after %.1f s", 2.0), false));

    assertThat(alone.words(command)).startsWith("`takeoff` from");
    assertThat(alone.words(world)).isEqualTo("time stands still");
    assertThat(alone.words(all)).startsWith("all goals are reached");
  }

  @Test
  void aDroneThatCannotBeSwitchedOnIsTheSubject() {
    LogQueue logQueue = new LogQueue();
    PortTakenException refusal = mock(PortTakenException.class);
    when(refusal.obstacle()).thenReturn(PortTakenException.Obstacle.FORBIDDEN);
    when(refusal.address()).thenReturn(new InetSocketAddress(InetAddress.getLoopbackAddress(), 80));
    logQueue.cannotSwitchOn(1, refusal);

    assertThat(alone.words(logQueue.drain().get(0))).startsWith("The drone cannot be switched on:");
  }

  @Test
  void whatIsSaidOfTheVideoHasASubject() {
    LogQueue logQueue = new LogQueue();
    logQueue.say(LogLevel.INFO, 1, Phrase.of("the video is being recorded: %s", "film.h264"));

    assertThat(alone.words(logQueue.drain().get(0))).startsWith("the video is being recorded");
  }

  private static LogRow row(LogLine line) {
    return new LogRow(0, List.of(new LogRow.Arrival(0, line)));
  }

  private static LogLine flight(FlightEvent event) {
    return LogLine.of(new SimEvent.DroneFlight(SimTime.ZERO, 1, event));
  }
}
