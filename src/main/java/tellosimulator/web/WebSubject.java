package tellosimulator.web;

import tellosimulator.control.Requests;
import tellosimulator.goal.GoalWatch;
import tellosimulator.network.OnlineSimulation;
import tellosimulator.scenario.Scenario;
import tellosimulator.scenery.SceneBuilder;
import tellosimulator.video.VideoStreams;

/**
 * What the page shows and controls.
 *
 * @param scenes builds the scenes, with the textures that the drones' cameras use
 * @param requests carries out what a viewer asks for
 */
public record WebSubject(
    OnlineSimulation simulation,
    Scenario scenario,
    GoalWatch goals,
    VideoStreams video,
    SceneBuilder scenes,
    Requests requests) {}
