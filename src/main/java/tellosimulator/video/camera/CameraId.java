package tellosimulator.video.camera;

/**
 * Identifies a camera of a drone.
 *
 * @param drone its number, from 1
 * @param downward whether it is the camera that looks down
 */
public record CameraId(int drone, boolean downward) {}
