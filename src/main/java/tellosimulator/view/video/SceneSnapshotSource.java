package tellosimulator.view.video;

import tellosimulator.sim.SimSnapshot;
import tellosimulator.video.camera.CameraId;
import tellosimulator.video.camera.FrameSource;
import tellosimulator.video.picture.Picture;

/**
 * Films the window's own scene through a drone's camera, as long as that is cheap. Otherwise, and
 * for the camera that looks down, another source films. For one thread.
 */
final class SceneSnapshotSource implements FrameSource {

  private final SnapshotDesk desk;
  private final FrameSource other;
  private int[] argb = new int[0];

  SceneSnapshotSource(SnapshotDesk desk, FrameSource other) {
    this.desk = desk;
    this.other = other;
  }

  /** The scene may show a moment that is a little later than the snapshot. */
  @Override
  public void film(SimSnapshot snapshot, CameraId shot, Picture picture) {
    if (shot.downward() || !photographed(shot.drone(), picture)) {
      other.film(snapshot, shot, picture);
    }
  }

  /** Photographs of the same scene look the same, and as it is drawn but for details. */
  @Override
  public Object sight(SimSnapshot snapshot, CameraId shot) {
    return other.sight(snapshot, shot);
  }

  private boolean photographed(int drone, Picture picture) {
    if (!desk.accepts()) {
      return false;
    }
    int pixels = picture.width() * picture.height();
    if (argb.length != pixels) {
      argb = new int[pixels];
    }
    if (desk.take(new SnapshotOrder(drone, picture.width(), picture.height(), argb))) {
      PictureColors.fill(picture, argb);
      return true;
    }
    argb = new int[0]; // they may still come
    return false;
  }
}
