# made_up_run.awk: write the files of a run folder with MADE-UP numbers, to test the figures with. Nothing here was simulated.
# Use: awk -v folder=DIR -v trials=N -v model=cpg-h -f made_up_run.awk

function write_run(file) {
    file = folder "/run.json"
    print "{\n  \"what\": \"made-up numbers to test the figures with\",\n  \"object\": \"small-sphere\"," >file
    printf "  \"model\": \"%s\",\n  \"centre\": true,\n  \"seed\": 1,\n  \"trials\": %d\n}\n", model, trials >file
    close(file)
}

function write_trials(    file, i, progress, rotation, value, c, m) {
    file = folder "/trials.csv"
    print "# made-up numbers to test the figures with\ntrial,rotation_rad,reward,value,td_error,noise,s_c,s_m,s_s" >file
    for (i = 1; i <= trials; i++) {
        progress = i / trials
        rotation = 5 * progress + 2 * (rand() - 0.5)
        c = (1 + progress + 0.2 * rand()) / 3.5
        m = (1 - c) / 2
        printf "%d,%.6g,%.6g,%.6g,%.6g,%.4g,%.6g,%.6g,%.6g\n", i, rotation, rotation, value, rotation - value, \
            progress < 0.6 ? 0.5 - 0.75 * progress : 0.05, c, m, 1 - c - m >file
        value = rotation
    }
    close(file)
}

function write_trajectory(    file, i, t, wave, press) {
    file = folder "/trajectory.csv"
    printf "# made-up numbers to test the figures with\nstep,time_s" >file
    printf ",desired_fei_rad,actual_fei_rad,torque_fei_nm,desired_aai_rad,actual_aai_rad,torque_aai_nm" >file
    printf ",desired_fet_rad,actual_fet_rad,torque_fet_nm,desired_ot_rad,actual_ot_rad,torque_ot_nm" >file
    printf ",index_x_m,index_y_m,index_z_m,thumb_x_m,thumb_y_m,thumb_z_m" >file
    print ",object_rad,index_contact_n,thumb_contact_n,finger_clearance_m" >file
    for (i = 1; i <= 300; i++) {
        t = i / 100
        wave = sin(6 * t)
        press = wave > 0 ? wave : 0
        printf "%d,%.2f", i, t >file
        printf ",%.4g,%.4g,0.01", 0.7 + 0.4 * wave, 0.7 + 0.4 * sin(6 * t - 0.2) >file
        printf ",%.4g,%.4g,0.01", 0.2 * cos(6 * t), 0.2 * cos(6 * t - 0.2) >file
        printf ",%.4g,%.4g,0.01", 0.7 - 0.4 * wave, 0.7 - 0.4 * sin(6 * t - 0.2) >file
        printf ",%.4g,%.4g,0.01", 1.2 - 0.4 * cos(6 * t), 1.2 - 0.4 * cos(6 * t - 0.2) >file
        printf ",%.4g,%.4g,%.4g", 0.06 + 0.02 * wave, -0.02 + 0.02 * cos(6 * t), 0.03 + 0.02 * wave >file
        printf ",%.4g,%.4g,%.4g", 0.02 - 0.02 * wave, 0.02 * cos(6 * t), 0.06 - 0.01 * wave >file
        printf ",%.4g,%.4g,%.4g,0.02\n", 1.5 * t + 0.1 * wave, press, press ? 0 : -wave >file
    }
    close(file)
}

function write_outline(    file, i, angle) {
    file = folder "/object_outline.csv"
    print "# made-up numbers to test the figures with\nx_m,y_m,z_m" >file
    for (i = 0; i <= 24; i++) {
        angle = i * 6.283185307 / 24
        printf "%.6g,%.6g,0.054\n", 0.04 + 0.028 * cos(angle), 0.028 * sin(angle) >file
    }
    print "" >file
    for (i = 0; i <= 24; i++) {
        angle = i * 6.283185307 / 24
        printf "%.6g,0,%.6g\n", 0.04 + 0.028 * cos(angle), 0.054 + 0.028 * sin(angle) >file
    }
    close(file)
}

BEGIN {
    srand(1)
    write_run()
    write_trials()
    write_trajectory()
    write_outline()
}
