package tellosimulator.recording;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;

/**
 * Writes the files of a small recording by hand, so that reading does not depend on this version's
 * writer. A drone takes off at 4 s, flies 100 cm forward from 8 s on and lands at 12 s.
 */
public final class RecordingFixture {

  /** The text that a hostile program sends. */
  public static final String MARKUP = "</script><script>document.title='run'</script>";

  private static final String RUN =
      """
      {"format":1,"program":"1.0.0","seed":7,"timeFactor":"1","begun":"2026-03-01T10:00:00Z",
       "started":4.0,"scenario":"Two <b>gates</b>","room":{"width":500,"depth":600,"height":300},
       "drones":[{"number":1,"profile":"edu","behaviour":"report",
         "start":{"x":-100,"y":50,"heading":90},"color":"#0072b2"}],
       "options":["--headless"],"ended":15.0,"result":"missed","unknown":{"later":[1]}}
      """;

  private static final String EVENTS =
      """
      {"t":1.0,"drone":1,"kind":"command","severity":"information","text":"`command` from a:1","command":"command","number":1}
      {"t":1.005,"drone":1,"kind":"reply","severity":"information","text":"`command` answered `ok`","command":"command","number":1,"reply":"ok"}
      {"t":4.0,"drone":1,"kind":"command","severity":"information","text":"`takeoff` from a:1","command":"takeoff","number":2}
      {"t":4.2,"drone":1,"kind":"took-off","severity":"information","text":"took off","x":-100,"y":50,"z":0}
      {"t":7.5,"drone":1,"kind":"reply","severity":"information","text":"`takeoff` answered `ok`","command":"takeoff","number":2,"reply":"ok"}
      {"t":8.0,"drone":1,"kind":"command","severity":"information","text":"`forward 100` from a:1","command":"forward 100","number":3}
      {"t":8.5,"drone":1,"kind":"command","severity":"detail","text":"`battery?` from a:1","command":"battery?","number":4}
      {"t":8.5,"drone":1,"kind":"reply","severity":"detail","text":"`battery?` answered `87`","command":"battery?","number":4,"reply":"87\\r\\n"}
      {"t":9.0,"drone":1,"kind":"command","severity":"information","text":"`cw 90` from a:1","command":"cw 90","number":5}
      {"t":9.0,"drone":1,"kind":"refused","severity":"warning","text":"`cw 90` refused: forward 100 is not over","command":"cw 90","number":5,"reply":"error Not joystick","reason":"`forward 100` is not over","x":-60,"y":50,"z":80}
      {"t":9.5,"drone":1,"kind":"touched","severity":"information","text":"touched the obstacle pole at 0.4 m/s","x":-50,"y":50,"z":80}
      {"t":10.5,"drone":1,"kind":"reply","severity":"information","text":"`forward 100` answered `ok`","command":"forward 100","number":3,"reply":"ok"}
      {"t":11.0,"drone":1,"kind":"command","severity":"information","text":"`MARKUP_HERE` from a:1","command":"MARKUP_HERE","number":6}
      {"t":11.0,"drone":1,"kind":"refused","severity":"warning","text":"`MARKUP_HERE` refused: nobody knows it","command":"MARKUP_HERE","number":6,"reply":"unknown command: MARKUP_HERE","reason":"nobody knows MARKUP_HERE"}
      {"t":12.0,"drone":1,"kind":"command","severity":"information","text":"`land` from a:1","command":"land","number":7}
      {"t":14.0,"drone":1,"kind":"landed","severity":"information","text":"landed"}
      {"t":14.1,"drone":1,"kind":"reply","severity":"information","text":"`land` answered `ok`","command":"land","number":7,"reply":"ok"}
      {"t":14.5,"kind":"goal","severity":"information","text":"goals: 1 of 2 reached after 10.0 s"}
      """;

  private static final String GOALS =
      """
      [{"text":"reach x 0, y 50, z 80 cm","reached":10.5},{"text":"land on the mission pad 3","reached":null}]
      """;

  private static final String HEADER =
      "t_s,drone,x_cm,y_cm,z_cm,roll_deg,pitch_deg,heading_deg,vx_cm_s,vy_cm_s,vz_cm_s,phase,"
          + "battery_pct,rc_a,rc_b,rc_c,rc_d,state_h_cm,state_tof_cm,state_baro_m,state_yaw_deg,"
          + "state_bat_pct,command\n";

  private final Path folder;

  /**
   * @param folder the folder to create
   */
  public RecordingFixture(Path folder) {
    this.folder = folder;
    try {
      Files.createDirectories(folder);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Writes the whole recording. */
  public static Path in(Path folder) {
    new RecordingFixture(folder).run(RUN).events().samples(15).with("goals.json", GOALS);
    return folder;
  }

  /** Writes {@code run.json} with a part of it replaced. */
  public RecordingFixture runWith(String part, String replacement) {
    if (!RUN.contains(part)) {
      throw new IllegalArgumentException("part is " + part + ", but there is none");
    }
    return run(RUN.replace(part, replacement));
  }

  public RecordingFixture run(String text) {
    return with("run.json", text);
  }

  public RecordingFixture events() {
    return with("events.jsonl", EVENTS.replace("MARKUP_HERE", MARKUP));
  }

  /**
   * Writes a row every 0.05 s: up to 80 cm within 2 s, 100 cm forward from 8 s on, and down from 12
   * s on.
   */
  public RecordingFixture samples(double end) {
    StringBuilder rows = new StringBuilder(HEADER);
    for (int i = 80; i <= Math.round(end * 20); i++) {
      double time = i / 20.0;
      double up = Math.min(80, 40 * (time - 4)) - Math.max(0, Math.min(80, 40 * (time - 12)));
      double ahead = Math.max(0, Math.min(100, 50 * (time - 8)));
      boolean moves = time >= 8 && time < 10;
      rows.append(
          String.format(
              Locale.ROOT,
              "%.3f,1,%.1f,50.0,%.1f,1.5,-2.0,0.0,%d,0,0,%s,%.1f,0,0,0,0,,,,,,%s%n",
              time,
              ahead - 100,
              up,
              moves ? 50 : 0,
              time < 6 ? "taking-off" : time < 12 ? "flying" : time < 14 ? "landing" : "grounded",
              90 - time,
              moves ? "\"forward 100\"" : ""));
    }
    return with("flight.csv", rows.toString().replace(System.lineSeparator(), "\n"));
  }

  /** Writes a file. */
  public RecordingFixture with(String name, String text) {
    try {
      Files.writeString(folder.resolve(name), text);
      return this;
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
