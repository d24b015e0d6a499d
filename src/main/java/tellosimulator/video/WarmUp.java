package tellosimulator.video;

import java.util.List;
import tellosimulator.concurrent.Verdict;
import tellosimulator.concurrent.Worker;
import tellosimulator.model.VideoSettings;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.sim.Simulation;
import tellosimulator.video.codec.H264Encoder;

/**
 * Renders and encodes some frames that nobody gets, in the background while the program starts, so
 * that the code is loaded and the room's textures are painted when an operator asks for video.
 * Nothing waits for it. For any thread.
 */
public final class WarmUp {

  /** Measured on two processors: the first IDR frame after 40 rather than 350 ms. */
  private static final int FRAMES = 1;

  /**
   * Whether the heap has room for frames that nobody has asked for. Measured: they take 36 MB; with
   * a heap of 32 MB they took the memory that the start itself needed.
   */
  private static final boolean AFFORDABLE = Runtime.getRuntime().maxMemory() >= 64L << 20;

  private WarmUp() {}

  /**
   * Starts, and ends by itself.
   *
   * @param cameras whose textures are painted
   */
  public static void start(SoftwareCameras cameras) {
    if (AFFORDABLE) {
      Verdict failed = Verdict.finish("Video could not be warmed up");
      Worker.once("video-warm-up", failed, () -> film(cameras));
    }
  }

  private static void film(SoftwareCameras cameras) {
    SimSnapshot snapshot =
        new Simulation(SimConfig.DEFAULT, drone -> (peer, text) -> {}, report -> {}, List.of())
            .snapshot();
    VideoFormat format = VideoFormat.of(VideoSettings.DEFAULT);
    Film film = new Film(1, cameras.get(), H264Encoder::new);
    for (int i = 0; i < FRAMES; i++) {
      film.shoot(snapshot, format);
      film.encode(i * format.period(), false);
    }
  }
}
