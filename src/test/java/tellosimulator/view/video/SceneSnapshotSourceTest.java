package tellosimulator.view.video;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.sim.Simulation;
import tellosimulator.video.camera.CameraId;
import tellosimulator.video.picture.Picture;

/** When the window's scene is photographed for a drone's video, and when another source films. */
class SceneSnapshotSourceTest {

  private static final long MS = 1_000_000;
  private static final long MINUTE = 60_000 * MS;
  private static final CameraId AHEAD = new CameraId(1, false);
  private static final CameraId BELOW = new CameraId(1, true);

  /** Brightness of what is photographed, and of what the other source draws. */
  private static final byte PHOTOGRAPHED = (byte) 235;

  private static final byte DRAWN = 50;

  private final AtomicLong now = new AtomicLong(1);
  private final SnapshotDesk desk = new SnapshotDesk(now::get);
  private final SimSnapshot snapshot =
      new Simulation(SimConfig.DEFAULT, drone -> (peer, text) -> {}, report -> {}, List.of())
          .snapshot();
  private final SceneSnapshotSource source =
      new SceneSnapshotSource(desk, (moment, shot, picture) -> Arrays.fill(picture.y(), DRAWN));
  private final List<Integer> drones = new ArrayList<>();
  private long cost = MS;

  @Test
  void nobodyIsAskedWhileTheDeskIsClosedOrNothingIsKnown() {
    assertThat(filmed(AHEAD)).isEqualTo(DRAWN);
    desk.open();
    assertThat(filmed(AHEAD)).isEqualTo(DRAWN);
  }

  @Test
  void cheapPicturesAreTakenOfTheSceneForWhicheverDrone() {
    beCheap();

    assertThat(filmedWhileServing(AHEAD)).isEqualTo(PHOTOGRAPHED);
    assertThat(filmedWhileServing(new CameraId(4, false))).isEqualTo(PHOTOGRAPHED);
    assertThat(drones).endsWith(1, 4);
  }

  @Test
  void theCameraBelowIsNeverPhotographed() {
    beCheap();

    assertThat(filmed(BELOW)).isEqualTo(DRAWN);
  }

  @Test
  void dearPicturesAreDrawnInstead() {
    cost = 9 * MS;
    desk.open();
    serveAll();

    assertThat(drones).as("tried out").hasSize(SnapshotCosts.FEWEST);
    assertThat(filmed(AHEAD)).isEqualTo(DRAWN);
  }

  @Test
  void picturesThatBecomeDearAreDrawnAndTriedOutAgainAfterAMinute() {
    beCheap();
    cost = 9 * MS;
    for (int i = 0; i < SnapshotCosts.MOST; i++) {
      filmedWhileServing(AHEAD);
    }
    assertThat(filmed(AHEAD)).isEqualTo(DRAWN);

    cost = MS;
    now.addAndGet(MINUTE + MS);
    assertThat(filmed(AHEAD)).as("trials are never shown").isEqualTo(DRAWN);
    serveAll();
    assertThat(filmedWhileServing(AHEAD)).isEqualTo(PHOTOGRAPHED);
  }

  @Test
  void trialsBecomeRarer() {
    cost = 43 * MS;
    desk.open();
    List<Integer> tried = new ArrayList<>();
    for (int minute = 0; minute < 16; minute++) {
      serveAll();
      tried.add(drones.size() / SnapshotCosts.FEWEST);
      now.addAndGet(MINUTE + MS);
      filmed(AHEAD);
    }

    // at once, then one, two, four and eight minutes later
    assertThat(tried).containsExactly(1, 2, 2, 3, 3, 3, 3, 4, 4, 4, 4, 4, 4, 4, 4, 5);
  }

  @Test
  void aWindowThatDoesNotAnswerIsWaitedForOnce() {
    beCheap();

    assertThat(filmed(AHEAD)).isEqualTo(DRAWN);
    assertThat(desk.accepts()).isFalse();
  }

  @Test
  void aClosedDeskHoldsNobodyUp() {
    beCheap();
    desk.close();

    assertThat(desk.accepts()).isFalse();
    assertThat(filmed(AHEAD)).isEqualTo(DRAWN);
  }

  @Test
  void aPulseDoesNotTakeAllPicturesIfTheyAreManyAndDear() {
    cost = 5 * MS;
    desk.open();
    desk.serve(this::photograph);

    // 5 ms and 5 ms are more than 8 ms, so the third one waits
    assertThat(drones).hasSize(2);
  }

  private void beCheap() {
    desk.open();
    serveAll();
    assertThat(desk.accepts()).isTrue();
  }

  private void serveAll() {
    for (int i = 0; i < SnapshotCosts.FEWEST; i++) {
      desk.serve(this::photograph);
    }
  }

  private void photograph(SnapshotOrder order) {
    drones.add(order.drone());
    Arrays.fill(order.argb(), 0xffffffff);
    now.addAndGet(cost);
  }

  private byte filmed(CameraId shot) {
    Picture picture = new Picture(4, 4);
    source.film(snapshot, shot, picture);
    return picture.y()[5];
  }

  /** What is filmed while this thread serves as that of JavaFX does. */
  private byte filmedWhileServing(CameraId shot) {
    Picture picture = new Picture(4, 4);
    Thread film = new Thread(() -> source.film(snapshot, shot, picture), "film");
    film.start();
    while (film.isAlive()) {
      desk.serve(this::photograph);
    }
    return picture.y()[5];
  }
}
