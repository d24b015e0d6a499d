package tellosimulator.video.camera;

/**
 * Identifies a camera of a drone.
 *
 * @param drone the drone's number, from 1
 * @param downward whether this is the downward camera rather than the forward camera
 */
public record CameraId(int drone, boolean downward) {}
